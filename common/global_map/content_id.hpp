/// @file A number for what a map says.
#pragma once

#include <cstdint>

#include "common/model/map.hpp"

namespace perceptor::global_map {

/// Equal for maps that say the same: types, names, free sides and the points of the objects, in
/// order, with their locations (to the micrometre), kinds and connections. Positive. The 64-bit
/// FNV-1a hash, less its sign bit: two different maps share it by chance of 1 in 9e18.
std::int64_t content_id(const Map& map);

}  // namespace perceptor::global_map
