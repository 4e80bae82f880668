/// @file A laser scan becomes the current map: walls with floating ends, and corners.
///
///   1. where each beam ends, the sweep corrected; beams without a return left out;
///   2. cut where the range jumps;
///   3. cut where the direction turns, on resampled points (the configured method);
///   4. cuts made exact on all beams, neighbours merged that one line explains;
///   5. each wall's line by total least squares weighted by each beam's own error;
///   6. ends trimmed to the beams that support them; corners.
#pragma once

#include <vector>

#include "common/model/laser_scan.hpp"
#include "common/model/map.hpp"
#include "components/scan/parameters.hpp"

namespace perceptor::scan {

/// What one scan shows, in the robot frame at the time of its first beam.
struct CurrentMap {
  /// Walls by bearing, each from its first point to its second counter-clockwise around the
  /// laser, so that its free side is left. All ends are floating; `method` says where a corner
  /// was seen, and ends with method `intersection` lie where two walls meet. After the walls'
  /// points, the corners that no wall ends in: points without parents. Weights are inverse
  /// variances [1/m^2]: of a wall across itself at its middle, of a point the mean of both axes.
  Map map;
  std::size_t no_return = 0;     ///< beams without a usable range
  std::size_t in_footprint = 0;  ///< beams that end on the robot itself
};

/// The robot moves at `twist` while the laser sweeps. Beams that end inside `footprint` (a
/// polygon in the robot frame; empty: none) are left out. Any number of beams, 0 included.
CurrentMap extract_walls(const LaserScan& scan, const Twist& twist,
                         const std::vector<Vector2>& footprint, const ScanParameters& parameters);

}  // namespace perceptor::scan
