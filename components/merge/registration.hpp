/// @file Where the robot is in the local frame: predicted by odometry, corrected by laying the
/// scan's walls on those of the map.
///
/// The correction is an iterated extended Kalman update, computed as weighted least squares on
/// the offset and angle between matched lines and the shift between their ends, with a Cauchy
/// weight against outliers (Z. Zhang, "Parameter estimation techniques", Image and Vision
/// Computing 15, 1997). Along a direction that neither fixes (a corridor without doorways) nothing
/// is corrected: odometry rules there.
#pragma once

#include <optional>
#include <vector>

#include "common/geometry/pose_estimate.hpp"
#include "components/merge/normal_equations.hpp"
#include "components/merge/same_wall.hpp"
#include "components/merge/wall.hpp"

namespace perceptor::merge {

struct RegistrationParameters {
  MotionNoise odometry;
  Landmarks landmarks = Landmarks::both;  ///< `corners` shows how the robot moved by these alone
  SameWallParameters same_wall{.offset = 0.1,
                               .angle = 0.1,
                               .sigmas = 3.0,
                               .max_offset = 0.35,
                               .max_angle = 0.35,
                               .max_gap = 0.0,
                               .shift = 0.35};  ///< what may be matched
  int rounds = 2;                               ///< of matching anew
  int iterations = 4;                           ///< of least squares in a round
  double outlier_sigmas = 2.0;                  ///< a line this far off counts half
  double annealing = 10.0;                      ///< the round before doubts so many times less
  double max_correction = 0.4;                  ///< [m] a larger one is not believed
  double max_heading_correction = 0.3;          ///< [rad] nor is this
  double min_agreement = 0.5;        ///< share of matched length that has to fit afterwards
  double unobservable_sigma = 0.05;  ///< [m] a direction in which the walls alone would leave
                                     ///< more is ruled by odometry
};

struct Registration {
  PoseEstimate robot_in_local;
  int matched = 0;        ///< walls of the scan that were laid on walls of the map
  bool rejected = false;  ///< not believed: the prediction stands, and the scan does not fit
  std::optional<Vector2> unobservable;  ///< unit vector along which odometry rules, local frame
};

/// `sighted` and the laser's place in the robot frame; `known`, with their lines, in the local
/// frame.
Registration register_walls(const std::vector<Wall>& sighted, const std::vector<Wall>& known,
                            const std::vector<Line>& known_lines, const PoseEstimate& predicted,
                            const Vector2& laser_in_robot, const SameWallParameters& agreement,
                            const RegistrationParameters& parameters);

}  // namespace perceptor::merge
