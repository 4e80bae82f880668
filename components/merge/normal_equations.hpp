/// @file What matched walls and the corners at their ends say of the robot's pose.
#pragma once

#include <cstdint>

#include "components/merge/wall.hpp"

namespace perceptor::merge {

/// What of a scan is laid on the map.
enum class Landmarks : std::uint8_t {
  walls,    ///< the lines of walls
  corners,  ///< the places of walls' ends that are corners
  both      ///< lines, and along them the ends that no line fixes: those that beams passed
};

/// Weighted normal equations of the pose (x, y, a) in the local frame.
struct NormalEquations {
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
  double spurious = 0.0;  ///< [1/m^2] of translation, that the walls' angle noise alone makes
};

/// Offset and angle of a sighted line on a known one. `sighted` in the robot frame, `known` with
/// its line in the local frame. What is `outlier_sigmas` off counts half (Cauchy).
void add_line(NormalEquations& equations, const Position& robot_in_local, const Wall& sighted,
              const Wall& known, const Line& known_line, double outlier_sigmas);

/// How far the ends of a sighted wall that are corners lie from those of the known one: in the
/// plane, or, `along_only`, those that are seen as ends along the known wall. Corners more than
/// `max_shift` [m] apart are not the same.
void add_corners(NormalEquations& equations, const Position& robot_in_local, const Wall& sighted,
                 const Wall& known, const Line& known_line, bool along_only, double max_shift,
                 double outlier_sigmas);

}  // namespace perceptor::merge
