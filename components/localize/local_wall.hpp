/// @file A wall of the local map, as localize compares it with the known building.
#pragma once

#include <array>
#include <vector>

#include "common/geometry/line.hpp"
#include "common/model/map.hpp"

namespace perceptor::localize {

/// Free space on the left of a to b.
struct LocalWall {
  Segment segment;  ///< [m]
  Line line;
  Eigen::Matrix2d covariance;            ///< of the line at its middle: offset [m], angle [rad]
  std::array<bool, 2> is_corner{};       ///< its ends a and b are ends of the wall
  std::array<double, 2> end_variance{};  ///< [m^2] along the wall
};

/// The walls of a map that were seen at `since` [us] or later, and whose free side is known.
std::vector<LocalWall> local_walls(const Map& local_map, std::int64_t since);

LocalWall transform(const Position& map_in_new, const LocalWall& wall);

}  // namespace perceptor::localize
