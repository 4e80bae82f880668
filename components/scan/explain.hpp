/// @file Why a beam is part of a wall, or of none: for people who look for a wall that was not
/// found.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "components/scan/extractor.hpp"

namespace perceptor::scan {

inline constexpr std::size_t kNoRun = std::numeric_limits<std::size_t>::max();

/// What became of a beam.
enum class Fate {
  no_return,     ///< its range is none, see is_return
  on_robot,      ///< it ends inside the footprint
  stray,         ///< it jumps away from both its neighbours, which belong together
  in_no_run,     ///< with its neighbours it makes no run that one line explains
  without_wall,  ///< its run is no wall: see RunAccount::verdict
  off_line,      ///< its run is a wall, but it lies too far from the wall's line
  supports,      ///< its run is a wall, and it is part of it
};

/// Beams that were measured one after the other and shared a fate.
struct BeamGroup {
  std::size_t first_beam = 0;  ///< index into the scan
  std::size_t last_beam = 0;   ///< inclusive
  Fate fate = Fate::no_return;
  std::size_t run = kNoRun;  ///< index into Account::runs, where the fate is one of a run's
};

/// What a run ends at.
enum class Limit {
  scan_end,  ///< there are no more beams
  gap,       ///< no wall can go on to the next beam: it is too far away
  strays,    ///< beams in no run follow
  corner,    ///< the next run goes on from here, in another direction
};

struct RunEnd {
  Limit limit = Limit::scan_end;
  double step = 0.0;  ///< [m] to the next beam; 0 at the scan's end
  double turn = 0.0;  ///< [rad] to the next run's line, positive to the left; only at a corner
};

/// A run, and what the wall it may be was judged by.
struct RunAccount {
  std::size_t first_beam = 0;  ///< index into the scan, by bearing
  std::size_t last_beam = 0;
  std::size_t beams = 0;
  Verdict verdict = Verdict::wall;
  std::size_t wall = kNoWall;  ///< index into Extraction::walls
  int support = 0;             ///< beams within some sigmas of the line
  double share = 0.0;          ///< [-] of the beams between the first and the last of these
  double length = 0.0;         ///< [m] between these two, on the line
  double angle_sigma = 0.0;    ///< [rad] standard deviation of the line's direction
  RunEnd before{};             ///< at its first beam
  RunEnd after{};              ///< at its last beam
};

struct Account {
  std::vector<BeamGroup> groups;   ///< all beams of the scan, in the order of measurement
  std::vector<RunAccount> runs{};  ///< by bearing, beginning anywhere
};

/// Of the scan that the extractor worked on last.
Account explain(const WallExtractor& extractor, const LaserScan& scan);

}  // namespace perceptor::scan
