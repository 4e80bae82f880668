/// @file The ends of walls that can bound an opening.
#pragma once

#include <cstdint>
#include <vector>

#include "components/identify/openings.hpp"

namespace perceptor::identify {

/// What can bound an opening, the most certain first.
enum class BoundKind : std::uint8_t { corner, outer_end, turned_end, loose_end, face };

/// An end of a wall that can bound an opening.
struct Bound {
  BoundKind kind = BoundKind::loose_end;
  const Wall* wall = nullptr;
  const WallEnd* end = nullptr;
  Index partner = kNone;  ///< the point that forms the corner with it
};

inline bool is_convex(BoundKind kind) {
  return kind == BoundKind::corner || kind == BoundKind::outer_end;
}

/// The ends that can bound an opening, by x (and then whatever tells two ends apart), so that
/// those near each other are found without looking at all pairs, and the order of the map's
/// objects does not show.
std::vector<Bound> find_bounds(const Map& map, const std::vector<Wall>& walls,
                               const OpeningParameters& parameters);

}  // namespace perceptor::identify
