/// @file Corners of a map against the true ones.
#pragma once

#include <vector>

#include "common/model/map.hpp"
#include "tools/eval/explained_beams.hpp"
#include "tools/eval/seen_sides.hpp"
#include "tools/eval/true_world.hpp"

namespace perceptor {

struct CornerScoreParameters {
  double max_offset = 0.15;  ///< [m] from the true corner it stands for; farther: it is none
};

/// Over all corners of all maps that were scored.
struct CornerScore {
  Share right;                 ///< of the corners found, those at a true one that can be seen
  double squared_error = 0.0;  ///< [m^2] sum over those
  Share confused;              ///< of those whose true type is known, typed the other way

  double rms() const;  ///< [m]; 0 where there are none
};

enum class CornerFault { none_there, wrong_type };

struct WrongCorner {
  Vector2 location = Vector2::Zero();  ///< [m] world frame
  CornerFault fault = CornerFault::none_there;
};

/// Gives those that are wrong. Of each corner that is convex or concave and joins two walls,
/// counted once. `map` in the world frame. A true corner's type follows from the side that its
/// walls were seen from.
std::vector<WrongCorner> score_corners(const Map& map, const TrueWorld& world,
                                       const SeenSides& seen,
                                       const CornerScoreParameters& parameters, CornerScore& score);

}  // namespace perceptor
