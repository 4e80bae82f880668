/// @file The scans that benchmarks are run on.
#pragma once

#include <vector>

#include "tests/support/scene.hpp"

namespace perceptor {

inline constexpr Twist kDriving{.vx = 0.5, .vy = 0.1, .va = 0.6};
inline const std::vector<Vector2> kFootprint = {{0.2, 0.2}, {-0.2, 0.2}, {-0.2, -0.2}, {0.2, -0.2}};

/// An L-shaped room with a pillar, seen by a noisy laser while the robot moves at `twist`:
///
///   +-----------+
///   |           |
///   |   []      +-----+
///   |  R              |
///   +-----------------+
inline LaserScan scan_of(std::size_t beams, const Twist& twist, std::uint64_t seed = 1) {
  test::Scene scene = test::room({{-1, -1}, {5, -1}, {5, 1.5}, {3, 1.5}, {3, 4}, {-1, 4}});
  const test::Scene pillar = test::room({{0.8, 1}, {1.2, 1}, {1.2, 1.4}, {0.8, 1.4}});
  scene.insert(scene.end(), pillar.begin(), pillar.end());
  const bool stands = twist.vx == 0.0 && twist.vy == 0.0 && twist.va == 0.0;
  const test::SceneLaser laser{.bearings = test::fan(beams, -2.0, 2.0),
                               .laser_in_robot = {0.1, 0.0, 0.0},
                               .sigma = 0.005,
                               .sweep_time = stands ? 0.0 : 0.02,
                               .seed = seed};
  return test::sweep(scene, laser, {}, twist);
}

}  // namespace perceptor
