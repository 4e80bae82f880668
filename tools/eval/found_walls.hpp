/// @file What an extractor found in one scan, in the robot's frame.
#pragma once

#include <vector>

#include "common/geometry/segment.hpp"

namespace perceptor {

/// A corner where two found walls meet.
struct FoundCorner {
  Vector2 location = Vector2::Zero();  ///< [m]
  bool is_convex = false;              ///< sticks out into free space
};

struct FoundWalls {
  std::vector<Segment> walls;  ///< [m] from its first beam to its last
  std::vector<FoundCorner> corners;
};

}  // namespace perceptor
