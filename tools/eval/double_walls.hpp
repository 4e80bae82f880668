/// @file Walls that stand in a map twice: what is left where the robot passed again and laid the
/// scan beside the wall that it knew.
#pragma once

#include <cstddef>
#include <cstdint>

#include "common/model/map.hpp"

namespace perceptor {

struct DoubleWallParameters {
  double max_age = 30.0;       ///< [s] since each was last seen; older ones may have drifted away
  double max_angle = 0.1745;   ///< [rad] between the two
  double max_distance = 0.30;  ///< [m] apart in the middle of their overlap; farther ones may be
                               ///< two walls
  double min_overlap = 0.30;   ///< [m] along the longer one; less is a joint of two pieces
};

/// Pairs of walls that cannot both be there: parallel, free on the same side, the one behind the
/// other but not on the same line. `utime` is that of the map. Walls whose free side or time
/// nobody knows are in no pair.
std::size_t count_double_walls(const Map& map, std::int64_t utime,
                               const DoubleWallParameters& parameters);

}  // namespace perceptor
