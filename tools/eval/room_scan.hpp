/// @file One scan of a floor plan, with the exact truth about what it sees.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "tools/eval/floor_plan.hpp"
#include "tools/eval/scan_set.hpp"

namespace perceptor {

/// A laser with evenly spaced beams, from right to left.
struct RoomLaser {
  std::size_t beams = 1000;  ///< at least 2
  double fov = 4.0;          ///< [rad] from the first beam to the last, straight ahead between;
                             ///< at most a full turn, whose last beam looks where the first did
  double range_min = 0.01;   ///< [m]
  double range_max = 10.0;   ///< [m] beyond it, no return
  double sigma = 0.01;       ///< [m] standard deviation of a range, Gaussian
  double outliers = 0.0;  ///< share of all beams that measure anything from range_min to range_max
  double dropouts = 0.0;  ///< share of all beams without a return
};

/// Which truth has to be found, the rest counting neither way, and what is truth at all.
struct TruthLimits {
  std::size_t min_returns = 10;        ///< of a piece that has to be found
  double min_length = 0.30;            ///< [m] of a piece that has to be found
  std::size_t min_corner_returns = 3;  ///< of each piece at a corner; with less, none is told
};

/// Where a beam truly ends.
struct BeamTarget {
  int wall = 0;                        ///< index into the walls
  double range = 0.0;                  ///< [m]
  Vector2 location = Vector2::Zero();  ///< [m] laser frame
};

/// [rad] laser frame.
std::vector<double> bearings(const RoomLaser& laser);

/// For each beam the nearest wall that turns its free side to the laser; none where that is
/// farther than range_max or nearer than range_min. Exact.
std::vector<std::optional<BeamTarget>> beam_targets(const std::vector<PlanWall>& walls,
                                                    const Position& laser_in_world,
                                                    const RoomLaser& laser);

/// What the laser makes of the targets.
struct Measurement {
  std::vector<double> ranges;          ///< [m] 0 where there is no return
  std::vector<bool> is_of_the_target;  ///< a return, and no outlier
};

/// `seed` and `scan` give the noise, the outliers and the drop-outs, each from a stream of its
/// own: a beam is an outlier or not whatever the plan and the other two are.
Measurement measure(const std::vector<std::optional<BeamTarget>>& targets, const RoomLaser& laser,
                    std::uint64_t seed, std::uint64_t scan);

/// The longest runs of beams that truly end on one wall, in the order of the beams. A run goes on
/// over drop-outs and outliers, but their beams are not counted in `returns`. Laser frame.
std::vector<TruePiece> true_pieces(const std::vector<std::optional<BeamTarget>>& targets,
                                   const std::vector<bool>& is_of_the_target,
                                   const TruthLimits& limits = {});

/// The corners between pieces of neighbouring walls where the one's last beam and the other's
/// first follow each other. One has to be found where both its pieces have to. Laser frame.
std::vector<TrueCorner> true_corners(const std::vector<PlanWall>& walls,
                                     const std::vector<TruePiece>& pieces,
                                     const Position& laser_in_world,
                                     const TruthLimits& limits = {});

/// All of these. The odometry is the true pose, and `doors` is empty. The scan claims a
/// range_sigma of 1 mm at least, since it is divided by.
LabelledScan scan_room(const std::vector<PlanWall>& walls, const Position& laser_in_world,
                       const RoomLaser& laser, std::uint64_t seed, std::uint64_t scan);

}  // namespace perceptor
