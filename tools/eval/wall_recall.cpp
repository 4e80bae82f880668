#include "tools/eval/wall_recall.hpp"

#include <algorithm>

namespace perceptor {
namespace {

/// Whether a wall of the map was seen from the same side as the true one.
bool faces_alike(const MapWall& wall, const Segment& side, FreeSide from) {
  if (wall.free_side == FreeSide::unknown) return true;
  const bool runs_along = direction(wall.segment).dot(direction(side)) > 0.0;
  return (wall.free_side == from) == runs_along;
}

/// Of the steps that were seen.
double covered_share(const std::vector<MapWall>& walls, const TrueSide& side, FreeSide from,
                     const SeenSide& seen, const WallRecallParameters& parameters) {
  std::vector<Segment> alike;
  for (const MapWall& wall : walls)
    if (length(wall.segment) > 0.0 && faces_alike(wall, side.segment, from) &&
        smallest_relative_angle(wall.segment, side.segment) < parameters.max_angle)
      alike.push_back(wall.segment);
  Share covered;
  for (std::size_t step = 0; step < seen.steps.size(); ++step) {
    if (!seen.steps[step]) continue;
    const Vector2 place = SeenSides::step_at(side, seen, step);
    const bool is_covered = std::ranges::any_of(
        alike, [&](const Segment& wall) { return distance(wall, place) < parameters.max_offset; });
    covered += {is_covered ? 1 : 0, 1};
  }
  return value(covered);
}

}  // namespace

WallRecall wall_recall(const std::vector<MapWall>& walls, const TrueWorld& world,
                       const SeenSides& seen, const WallRecallParameters& parameters) {
  WallRecall recall;
  const std::size_t sides = std::min(world.sides.size(), seen.size());
  for (std::size_t i = 0; i < sides; ++i) {
    const TrueSide& side = world.sides[i];
    if (side.surface == Surface::leaf) continue;
    for (const FreeSide from : {FreeSide::left, FreeSide::right}) {
      const SeenSide& part = seen.seen(i, from);
      if (part.since == 0) continue;
      const double covered = covered_share(walls, side, from, part, parameters);
      const bool is_found = covered >= parameters.min_share;
      (side.surface == Surface::wall ? recall.walls : recall.furniture) += {is_found ? 1 : 0, 1};
      if (!is_found) recall.missed.push_back({i, from, covered});
    }
  }
  return recall;
}

}  // namespace perceptor
