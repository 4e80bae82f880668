/// @file Which wall of the map is a sighted wall?
#pragma once

#include <cstddef>
#include <vector>

#include "components/merge/same_wall.hpp"

namespace perceptor::merge {

/// Indices into the sighted and the known walls.
struct Match {
  std::size_t sighted = 0;
  std::size_t known = 0;
};

/// Each sighted wall with the known wall that is most like it, where there is one. Both in the
/// local frame; a wall whose free side the laser is not on cannot be matched. The answer does
/// not depend on the order of either.
std::vector<Match> match_walls(const std::vector<Wall>& sighted, const std::vector<Wall>& known,
                               const std::vector<Line>& known_lines, const Vector2& laser_in_local,
                               const SameWallParameters& parameters);

}  // namespace perceptor::merge
