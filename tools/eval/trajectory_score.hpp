/// @file How far a trajectory is from what is known about it.
///
/// Neither score depends on where the two frames stand to each other: only motions are compared.
#pragma once

#include <cstdint>
#include <vector>

#include "tools/eval/pose_reference.hpp"
#include "tools/eval/trajectory.hpp"

namespace perceptor {

struct TrajectoryScoreParameters {
  double min_path = 10.0;  ///< [m] driven between the two poses of a pair; shorter pairs show
                           ///< noise more than drift
  double max_path = 20.0;  ///< [m]
  double max_gap = 5.0;    ///< [s] between poses of the trajectory; across a longer gap nothing is
                           ///< interpolated, and the reference there is skipped
};

/// The drift over stretches of the way: relative poses as A. Geiger et al., "Are we ready for
/// autonomous driving? The KITTI vision benchmark suite" (CVPR 2012), with every pair of
/// reference poses whose driven path lies within bounds.
struct DriftScore {
  std::int64_t poses = 0;              ///< of the reference
  std::int64_t skipped = 0;            ///< of those, where the trajectory says nothing
  std::int64_t pairs = 0;              ///< compared; all below are means over them, 0 without any
  double translation = 0.0;            ///< [m] error of the relative position
  double heading = 0.0;                ///< [rad] error of the relative heading, absolute
  double translation_per_metre = 0.0;  ///< [m/m] driven
  double heading_per_metre = 0.0;      ///< [rad/m] driven
};

/// `trajectory` and `reference` in order of time.
DriftScore score_drift(const Trajectory& trajectory, const Trajectory& reference,
                       const TrajectoryScoreParameters& parameters = {});

/// Over many errors.
struct MeanAndSigma {
  double mean = 0.0;
  double sigma = 0.0;  ///< standard deviation of the errors themselves, not of the mean
};

/// R. Kuemmerle et al., "On measuring the accuracy of SLAM algorithms", Autonomous Robots 27
/// (2009): the absolute errors of relative poses that somebody checked by hand.
struct RelationScore {
  std::int64_t relations = 0;
  std::int64_t skipped = 0;  ///< of those, where the trajectory says nothing at an end
  MeanAndSigma translation;  ///< [m]
  MeanAndSigma rotation;     ///< [rad]
};

/// `trajectory` in order of time.
RelationScore score_relations(const Trajectory& trajectory, const std::vector<Relation>& relations,
                              const TrajectoryScoreParameters& parameters = {});

}  // namespace perceptor
