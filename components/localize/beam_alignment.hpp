/// @file The pose that lays the ends of a scan's beams best on the faces of the known building:
/// iterated closest points, each end on the line of the nearest face that it can see (Y. Chen and
/// G. Medioni, "Object modelling by registration of multiple range images", Image and Vision
/// Computing 10, 1992), with Cauchy weights against what is not on the map.
///
/// Where the map is made of scans its walls stand off by a decimetre and are bent: no wall of a
/// scan lies on them, and what holds the pose are many small pieces, each of a few beams.
#pragma once

#include <vector>

#include "common/geometry/pose_estimate.hpp"
#include "components/localize/beam_fit.hpp"
#include "components/localize/world.hpp"

namespace perceptor::localize {

struct BeamAlignmentParameters {
  int iterations = 6;
  double reach = 0.4;        ///< [m] from an end to its face
  double min_cosine = 0.15;  ///< between a beam and the normal of its face
  double map_sigma = 0.1;    ///< [m] how far the walls stand off the map
  double outlier = 0.15;     ///< [m] an end this far off counts half
  double together = 10.0;    ///< so many beams err in the same way: they count as one
};

/// `start` is the robot's pose in the world; it counts as a measurement with its covariance.
PoseEstimate align_beams(const World& world, const std::vector<Beam>& beams,
                         const PoseEstimate& start, const BeamAlignmentParameters& parameters);

}  // namespace perceptor::localize
