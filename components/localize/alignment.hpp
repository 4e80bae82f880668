/// @file The pose that lays walls best on the faces of the known building: iterated weighted least
/// squares on the offset and angle between a wall and the nearest face that looks its way, and on
/// the place of its ends along it, with Cauchy weights against what is not on the map (Z. Zhang,
/// "Parameter estimation techniques", Image and Vision Computing 15, 1997).
#pragma once

#include <optional>
#include <vector>

#include "common/geometry/pose_estimate.hpp"
#include "components/localize/local_wall.hpp"
#include "components/localize/world.hpp"

namespace perceptor::localize {

struct AlignmentParameters {
  int iterations = 4;
  double max_offset = 0.25;     ///< [m] from a wall to its face
  double max_angle = 0.2;       ///< [rad]
  double max_shift = 0.25;      ///< [m] from a corner to that of its face, along it
  double min_overlap = 0.5;     ///< of the shorter of the two
  double map_sigma = 0.01;      ///< [m] how far the real walls stand off the map, at a guess
  double outlier_sigmas = 2.5;  ///< a wall this far off counts half
};

struct Alignment {
  PoseEstimate frame_in_world;
  int matched = 0;                     ///< walls that have a face
  double matched_length = 0.0;         ///< [m] of these, on their faces
  Eigen::Matrix3d map_covariance =     ///< what of the covariance is the map's own error: the same
      Eigen::Matrix3d::Zero();         ///< from scan to scan
  std::optional<double> map_variance;  ///< [m^2] how far the walls stood off the map, by what was
                                       ///< left over; none where too few walls matched
};

/// Lays the walls of one frame on the world's faces. `start` is the frame's pose in the world; with
/// `prior` it counts as a measurement with its covariance, else only the walls count, and where
/// they leave the pose loose there is none.
std::optional<Alignment> align(const World& world, const std::vector<LocalWall>& walls,
                               const PoseEstimate& start, bool prior,
                               const AlignmentParameters& parameters);

}  // namespace perceptor::localize
