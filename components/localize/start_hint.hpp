/// @file What is known beforehand of where the robot starts.
#pragma once

#include <optional>
#include <vector>

#include "common/geometry/position.hpp"

namespace perceptor::localize {

/// Near a pose, or in one of some areas.
struct StartHint {
  std::optional<Position> pose;             ///< world frame
  std::vector<std::vector<Vector2>> areas;  ///< [m] their corners, world frame; without a pose
  double distance = 0.5;                    ///< [m] from the pose, or outside the areas
  double angle = 0.5;                       ///< [rad] from the pose
};

/// Whether the robot may have started there.
bool allows(const StartHint& hint, const Position& robot_in_world);

}  // namespace perceptor::localize
