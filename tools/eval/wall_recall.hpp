/// @file How much of what has been seen of the world stands in a map.
#pragma once

#include <cstddef>
#include <vector>

#include "tools/eval/explained_beams.hpp"
#include "tools/eval/seen_sides.hpp"
#include "tools/eval/true_world.hpp"

namespace perceptor {

struct WallRecallParameters {
  double min_share = 0.7;    ///< of what was seen of a side: less, and it is missed
  double max_angle = 0.087;  ///< [rad] between a wall of the map and the true one
  double max_offset = 0.10;  ///< [m] of a step of the side from a wall of the map
};

/// A wall of the map [world frame], and from where it was seen.
struct MapWall {
  Segment segment;
  FreeSide free_side = FreeSide::unknown;
};

/// A side of the world that is missed.
struct MissedSide {
  std::size_t side = 0;  ///< in TrueWorld::sides
  FreeSide from = FreeSide::unknown;
  double covered = 0.0;  ///< share of its seen steps
};

struct WallRecall {
  Share walls;      ///< of the world's walls seen, covered by walls of the map
  Share furniture;  ///< of the sides of cabinets and boxes
  std::vector<MissedSide> missed;
};

/// A wall of the map covers only what is seen from its own free side; leaves of doors, which
/// move, are not asked for.
WallRecall wall_recall(const std::vector<MapWall>& walls, const TrueWorld& world,
                       const SeenSides& seen, const WallRecallParameters& parameters);

}  // namespace perceptor
