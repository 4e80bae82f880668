/// @file A tiny world of wall pieces, and a laser that sweeps it: for tests of what makes maps
/// of scans. Shares nothing with the simulator.
#pragma once

#include <cstdint>
#include <vector>

#include "common/geometry/segment.hpp"
#include "common/model/laser_scan.hpp"

namespace perceptor::test {

/// Seen from both sides.
using Scene = std::vector<Segment>;

/// The pieces from corner to corner, the last joined to the first.
Scene room(const std::vector<Vector2>& corners);

/// The pieces from corner to corner.
Scene chain(const std::vector<Vector2>& corners);

struct SceneLaser {
  std::vector<double> bearings;  ///< [rad] in order of measurement
  Position laser_in_robot;
  double sigma = 0.0;  ///< [m] of the ranges
  double claimed_sigma =
      -1.0;                 ///< [m] what the scan says of it; negative: the same, 0.001 at least
  double outliers = 0.0;    ///< share of beams with any range at all
  double dropouts = 0.0;    ///< share of beams without a return
  double sweep_time = 0.0;  ///< [s] from the first beam to the last
  double valid_max = 10.0;  ///< [m]
  std::uint64_t seed = 1;
};

/// Bearings from `first` to `last`, both included, counter-clockwise where last is larger.
std::vector<double> fan(std::size_t beams, double first, double last);

/// Bearings all around, the first at `first`, without the one that would repeat it.
std::vector<double> circle(std::size_t beams, double first = -3.14159265358979);

/// What a laser like PICO's sees: 1000 beams over [-2, 2] rad.
SceneLaser pico_laser(double sigma = 0.0, std::uint64_t seed = 1);

/// One sweep from where the robot is at the first beam, moving at `twist` while it lasts.
LaserScan sweep(const Scene& scene, const SceneLaser& laser, const Position& robot_in_world = {},
                const Twist& twist = {});

}  // namespace perceptor::test
