/// @file From one scan to its walls and corners. All memory is kept from scan to scan: once it
/// has grown to what the scans need, nothing is allocated any more.
///
/// The steps, each a file of its own:
///   1. beams: which returned, where they end, how certain that is;
///   2. gaps: where no wall can go on from one beam to the next; single strays go;
///   3. line_fit: sums of moments, so that the best line of any run of beams is a few operations;
///   4. methods: what lies between gaps is cut into runs that one line explains;
///   5. walls: the best line of each run, the beams that support it, its ends;
///   6. corners: where two walls meet, and where only one side of a corner is seen.
#pragma once

#include <cstddef>
#include <vector>

#include "components/scan/corners.hpp"
#include "components/scan/methods.hpp"

namespace perceptor::scan {

/// What one scan shows, in the robot frame at the time of its first beam.
struct Extraction {
  std::vector<Wall> walls;       ///< by bearing
  std::vector<Corner> corners;   ///< in the order of the walls, beginning anywhere
  std::size_t no_return = 0;     ///< beams without a usable range
  std::size_t in_footprint = 0;  ///< beams that end on the robot itself
};

class WallExtractor {
 public:
  /// Beams that end inside `footprint` (a polygon in the robot frame; empty: none) are left out.
  explicit WallExtractor(const ScanParameters& parameters, std::vector<Vector2> footprint = {});

  /// The robot moves at `twist` while the laser sweeps. Any number of beams, 0 included. What is
  /// found depends on this scan alone, and is valid until the next call.
  const Extraction& extract(const LaserScan& scan, const Twist& twist = {});

  // What was found last, and how it came to that.
  const Extraction& found() const { return found_; }
  const ScanParameters& parameters() const { return parameters_; }
  const Sweep& sweep() const { return sweep_; }
  const std::vector<RunResult>& runs() const { return results_; }
  /// Beams of the scan taken out as strays.
  const std::vector<std::size_t>& strays() const { return gaps_.strays(); }

 private:
  void reserve_for(std::size_t beams);
  void find_stretches();
  void fit_walls();
  void sort_by_bearing(const LaserScan& scan);

  ScanParameters parameters_;
  BeamReader reader_;
  Gaps gaps_;
  Sweep sweep_;
  Workspace workspace_;
  std::vector<Run> runs_;
  std::vector<RunResult> results_;
  Extraction found_;
};

}  // namespace perceptor::scan
