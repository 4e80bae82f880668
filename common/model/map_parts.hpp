/// @file A map that is too large for one message goes in parts.
#pragma once

#include <cstddef>
#include <vector>

#include "common/model/map.hpp"

namespace perceptor {

/// The objects of a map in order, at most `objects` of them and `points` points in each part (more
/// points where one object alone has them). Ids tell which object is which; a connection to a point
/// of another part is none. At least one part.
std::vector<Map> parts_of(const Map& map, std::size_t objects, std::size_t points);

}  // namespace perceptor
