/// @file Where the robot could be, from the walls around it alone.
///
/// Two walls that are not parallel, laid on two fronts of the building that stand to each other at
/// the same angle, fix the pose; so does one wall with an end that is a corner, laid on a face. All
/// such poses are tried (the interpretation tree of W. E. L. Grimson, "Object Recognition by
/// Computer", 1990, at its first two levels), and ranked by the length of wall that they explain.
/// Among clutter there may be one wall in view that the map has: the longest are also slid along
/// each front.
#pragma once

#include <vector>

#include "common/geometry/position.hpp"
#include "components/localize/laid_walls.hpp"
#include "components/localize/world.hpp"

namespace perceptor::localize {

struct CandidateParameters {
  int walls = 10;            ///< the longest, of which each two are tried
  double min_angle = 0.35;   ///< [rad] two walls closer to parallel do not fix a pose
  double max_angle = 0.08;   ///< [rad] between a wall and the front it is laid on
  double max_offset = 0.15;  ///< [m] the same
  double min_share = 0.5;    ///< of a wall that has to lie on its front
  double cell = 0.15;        ///< [m] candidates this close are one
  double cell_angle = 0.1;   ///< [rad] the same
  int slid = 3;              ///< walls that are slid along fronts, the longest
  double slide = 0.2;        ///< [m] from place to place
  int count = 5000;          ///< the best are kept
};

struct Candidate {
  Position local_in_world;
  double explained = 0.0;  ///< [m] of wall that lies on a front
};

LayTolerance tolerance_of(const CandidateParameters& parameters);

/// Best first; in an order that depends on nothing but walls and world.
std::vector<Candidate> find_candidates(const World& world, const std::vector<LocalWall>& walls,
                                       const CandidateParameters& parameters);

}  // namespace perceptor::localize
