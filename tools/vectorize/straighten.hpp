/// @file Straight walls out of outlines: corners by U. Ramer ("An iterative procedure for the
/// polygonal approximation of plane curves", 1972) and D. Douglas and T. Peucker (1973), lines
/// between them by total least squares, corners again where lines meet.
#pragma once

#include <functional>
#include <vector>

#include "common/geometry/line.hpp"
#include "tools/vectorize/trace.hpp"

namespace perceptor {

/// The straight pieces in order, each but the first beginning where the one before ends; a closed
/// outline's last ends where its first begins. `tolerance` [m]: no place lies farther off. `inset`:
/// how far a line is moved to its right, into what is occupied [m]. None for fewer than two places.
std::vector<Segment> straighten(const Outline& outline, double tolerance,
                                const std::function<double(const Line&)>& inset);

}  // namespace perceptor
