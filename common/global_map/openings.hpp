/// @file Buildings that are open: a corridor that ends nowhere, an exit without a door. Closing
/// lines across such gaps tell inside from outside. Nobody draws them: they are no walls.
#pragma once

#include <vector>

#include "common/global_map/arrangement.hpp"

namespace perceptor::global_map {

/// For each loose end of a wall that has the outside on both its sides: the shortest line
/// [m] from it, not backwards along its wall, to any other line, where that is at most
/// `max_opening` [m].
std::vector<Segment> closings(const Arrangement& arrangement, double max_opening);

}  // namespace perceptor::global_map
