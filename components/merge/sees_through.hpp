/// @file Do beams pass through a wall? A wall of the current scan stands where beams ended, so
/// every ray from the laser to a point of it passed through whatever lies between.
#pragma once

#include <optional>
#include <vector>

#include "components/merge/wall.hpp"

namespace perceptor::merge {

struct SeesThroughParameters {
  double behind = 0.2;        ///< [m] rays must end this far behind the wall's line; larger is
                              ///< safer against errors of the pose, and slower to see a change
  double end_margin = 0.1;    ///< [m] rays this near a wall's end say nothing about it
  double min_width = 0.1;     ///< [m] of the wall that must be passed through at once
  double min_distance = 0.1;  ///< [m] of the laser from the wall's line: not along it
};

/// The piece of `screen` through which rays from `laser` reach `target`, in metres from the
/// screen's tail; all in one frame. None where it is narrower than min_width.
std::optional<Interval> passed_through(const Segment& screen, const Vector2& laser,
                                       const Segment& target,
                                       const SeesThroughParameters& parameters);

/// The widest piece of `screen` through which rays reach any of the targets; pieces that
/// touch are one.
std::optional<Interval> widest_opening(const Segment& screen, const Vector2& laser,
                                       const std::vector<Wall>& targets,
                                       const SeesThroughParameters& parameters);

}  // namespace perceptor::merge
