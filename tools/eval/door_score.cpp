#include "tools/eval/door_score.hpp"

#include <algorithm>
#include <cmath>

#include "common/time/stamp.hpp"

namespace perceptor {

bool DoorScorer::counts(const TrueOpening& opening) const {
  const double width = length(opening.faces.front().segment);
  constexpr double kRounding = 0.002;  // [m] map files are written in millimetres
  return opening.is_open && width >= parameters_.min_width - kRounding &&
         width <= parameters_.max_width + kRounding &&
         opening.from_furniture >= parameters_.from_furniture;
}

bool DoorScorer::is_in_reach(const TrueOpening& opening, const Vector2& robot) const {
  return std::ranges::any_of(opening.faces, [&](const OpeningFace& face) {
    return distance(middle(face.segment), robot) <= parameters_.reach;
  });
}

bool DoorScorer::shows(const std::vector<SideView>& views, const TrueWorld& world,
                       const OpeningFace& face) const {
  for (std::size_t end = 0; end < 2; ++end) {
    const std::size_t index = face.adjoining[end];
    if (index == kNoSide) return false;
    const SideView& view = views[index];
    const Segment& wall = world.sides[index].segment;
    const Vector2& jamb = end == 0 ? face.segment.a : face.segment.b;
    const double at = distance(wall.a, jamb) < distance(wall.b, jamb) ? 0.0 : length(wall);
    if (view.beams < parameters_.wall.min_beams || view.seen() < parameters_.wall.min_length ||
        view.distance_to(at) > parameters_.jamb_reach)
      return false;
  }
  return true;
}

void DoorScorer::take_view(std::int64_t utime, const TrueWorld& world,
                           const std::vector<SideView>& views, const Vector2& robot_in_world) {
  constexpr double kPause = 0.5;  // [s] without a scan: time that does not count
  for (const TrueOpening& opening : world.openings) {
    if (!counts(opening) || !is_in_reach(opening, robot_in_world)) continue;
    Seen& seen = seen_[opening.id];
    if (seen.since == 0) {
      const bool is_shown = std::ranges::any_of(
          opening.faces, [&](const OpeningFace& face) { return shows(views, world, face); });
      if (!is_shown) continue;
      seen.since = utime;
    } else if (const double step = seconds_between(seen.last_in_reach, utime); step < kPause) {
      seen.time_in_reach += step;
    }
    seen.last_in_reach = utime;
  }
}

bool DoorScorer::matches(const TrueOpening& opening, const Segment& door) const {
  return std::ranges::any_of(opening.faces, [&](const OpeningFace& face) {
    return distance(middle(face.segment), middle(door)) < parameters_.max_offset &&
           std::abs(length(face.segment) - length(door)) < parameters_.max_width_error;
  });
}

std::optional<bool> DoorScorer::is_right(const TrueWorld& world, const Segment& door,
                                         const Vector2& robot_in_world) const {
  if (distance(middle(door), robot_in_world) > parameters_.reach) return std::nullopt;
  for (const TrueSide& side : world.sides)
    if (side.surface == Surface::furniture &&
        (distance(side.segment, door.a) < parameters_.from_furniture ||
         distance(side.segment, door.b) < parameters_.from_furniture))
      return std::nullopt;
  bool is_one = false;
  for (const TrueOpening& opening : world.openings) {
    if (!opening.is_open || !matches(opening, door)) continue;
    if (!counts(opening)) return std::nullopt;
    is_one = true;
  }
  return is_one;
}

std::vector<const TrueOpening*> DoorScorer::take_doors(std::int64_t utime, const TrueWorld& world,
                                                       const std::vector<Segment>& doors,
                                                       const Vector2& robot_in_world,
                                                       bool is_counted) {
  std::vector<const TrueOpening*> missing;
  if (is_counted)
    for (const Segment& door : doors)
      if (const auto right = is_right(world, door, robot_in_world))
        score_.right += {*right ? 1 : 0, 1};
  for (const TrueOpening& opening : world.openings) {
    if (!counts(opening)) continue;
    const bool is_published =
        std::ranges::any_of(doors, [&](const Segment& door) { return matches(opening, door); });
    Seen& seen = seen_[opening.id];
    if (is_published && seen.found == 0) seen.found = utime;
    const bool has_to_be = seen.since != 0 && is_in_reach(opening, robot_in_world) &&
                           seconds_between(seen.since, utime) > parameters_.min_time;
    if (!is_counted || !has_to_be) continue;
    score_.standing += {is_published ? 1 : 0, 1};
    if (!is_published) missing.push_back(&opening);
  }
  return missing;
}

void DoorScorer::add(const Seen& seen, DoorScore& score) const {
  if (seen.since == 0 || seen.time_in_reach <= parameters_.min_time) return;
  score.found += {seen.found != 0 ? 1 : 0, 1};
  // One found from farther away, or by less, has not been waited for.
  if (seen.found > seen.since) score.delays.push_back(seconds_between(seen.since, seen.found));
}

DoorScore DoorScorer::score() const {
  DoorScore score = score_;
  for (const auto& [id, seen] : seen_) add(seen, score);
  return score;
}

void DoorScorer::begin_anew() {
  for (const auto& [id, seen] : seen_) add(seen, score_);
  seen_.clear();
}

}  // namespace perceptor
