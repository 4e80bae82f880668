#include "tools/eval/seen_sides.hpp"

#include <algorithm>
#include <cmath>

namespace perceptor {

void SeenSides::take(std::int64_t utime, const TrueWorld& world, const std::vector<SideView>& views,
                     const Vector2& laser_in_world) {
  sides_.resize(std::max(sides_.size(), world.sides.size()));
  for (std::size_t i = 0; i < views.size(); ++i) {
    const SideView& view = views[i];
    if (view.beams < parameters_.min_beams || view.seen() < parameters_.min_length) continue;
    const Segment& side = world.sides[i].segment;
    SeenSide& seen = signed_distance(side, laser_in_world) > 0.0 ? sides_[i].left : sides_[i].right;
    if (seen.since == 0) {
      seen.since = utime;
      seen.steps.resize(std::max<std::size_t>(
          1, static_cast<std::size_t>(std::lround(length(side) / parameters_.step))));
    }
    const double step = length(side) / static_cast<double>(seen.steps.size());
    for (std::size_t s = 0; s < seen.steps.size(); ++s)
      if (view.distance_to((static_cast<double>(s) + 0.5) * step) == 0.0) seen.steps[s] = true;
  }
}

const SeenSide& SeenSides::seen(std::size_t side, FreeSide from) const {
  return from == FreeSide::left ? sides_[side].left : sides_[side].right;
}

FreeSide SeenSides::seen_from(std::size_t side) const {
  if (side >= sides_.size()) return FreeSide::unknown;
  const bool left = sides_[side].left.since != 0;
  const bool right = sides_[side].right.since != 0;
  if (left == right) return FreeSide::unknown;
  return left ? FreeSide::left : FreeSide::right;
}

Vector2 SeenSides::step_at(const TrueSide& side, const SeenSide& seen, std::size_t step) {
  const double share = (static_cast<double>(step) + 0.5) / static_cast<double>(seen.steps.size());
  return side.segment.a + share * (side.segment.b - side.segment.a);
}

}  // namespace perceptor
