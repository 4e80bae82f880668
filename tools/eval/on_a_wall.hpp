/// @file Whether what was found lies on something that is there.
#pragma once

#include <vector>

#include "common/geometry/segment.hpp"

namespace perceptor {

struct OnAWallParameters {
  double max_angle = 0.087;  ///< [rad] between a found wall and the true one
  double max_offset = 0.10;  ///< [m] of any point of a found wall from a true one
  double step = 0.05;        ///< [m] between the points of a found wall that are tried
};

/// Whether each point of the found wall lies on some true one that runs alike: it may cover
/// several that lie in one line. All in one frame.
bool is_on_a_wall(const Segment& found, const std::vector<Segment>& walls,
                  const OnAWallParameters& parameters);

}  // namespace perceptor
