/// @file The walls of one scan, made ready for merging.
#pragma once

#include <cstdint>
#include <vector>

#include "components/merge/wall.hpp"

namespace perceptor::merge {

struct SightingParameters {
  double min_length = 0.05;     ///< [m] shorter walls are not taken in
  double offset_sigma = 0.002;  ///< [m] added to the scan's own: what no scan can know of its
                                ///< mounting and timing; larger: each scan counts for less
  double angle_sigma = 0.002;   ///< [rad] the same of a wall's angle
  double end_sigma = 0.01;      ///< [m] the same of an end's place along its wall
  double unknown_offset_sigma = 0.02;  ///< [m] of a wall that comes without covariance
  double unknown_angle_sigma = 0.05;   ///< [rad] of such a wall
  double unknown_end_sigma = 0.02;     ///< [m] of an end that comes without covariance
  double radius = 0.2;                 ///< [m] of an end to which the scan gives none
  double max_radius = 0.3;             ///< [m] no end reaches further for a corner
};

/// The walls of a scan, robot frame, oriented with free space on their left. In an order that
/// depends on the walls alone, not on how they came: longest first. A wall of unknown free
/// side is taken to be seen from `viewpoint` [m, robot frame]. What is not a wall of two
/// points, or is too short, is left out.
std::vector<Wall> sighted_walls(const Map& current, const Vector2& viewpoint, std::int64_t utime,
                                const SightingParameters& parameters);

/// The wall seen from another frame whose own pose is uncertain: `pose_covariance` of
/// `robot_in_local` (x, y [m], a [rad]) adds to that of the line.
Wall transform(const Position& robot_in_local, const Eigen::Matrix3d& pose_covariance,
               const Wall& wall);

}  // namespace perceptor::merge
