/// @file Is an opening shut by a wall?
#pragma once

#include <vector>

#include "components/identify/openings.hpp"

namespace perceptor::identify {

/// The line of an opening: from one bound to the other, and the side that is free.
struct OpeningLine {
  Vector2 start = Vector2::Zero();   ///< [m] the first bound
  Vector2 along = Vector2::Zero();   ///< length one, to the second bound
  Vector2 before = Vector2::Zero();  ///< length one, perpendicular, to the free side
  double width = 0.0;                ///< [m]
};

/// Whether a wall crosses the opening, or stands across it close behind or before. `face`: the
/// wall on which the opening ends, if it does; nullptr: none.
bool is_shut(const OpeningLine& line, const std::vector<Wall>& walls, const Wall* face,
             const OpeningParameters& parameters);

}  // namespace perceptor::identify
