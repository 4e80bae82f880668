#include "tools/eval/world_score.hpp"

#include <algorithm>
#include <cmath>

#include "common/geometry/angle.hpp"
#include "common/messages/convert.hpp"

namespace perceptor {
namespace {

constexpr std::size_t kKept = 400;  // ten seconds of scans: truth and map stand closer

bool same_scan(const pico::truth_t& truth, const pico::map_t& map) {
  return truth.session == map.session && truth.seq == map.seq;
}

PoseError error_between(const Position& estimate, const Position& truth) {
  return {distance(estimate.location(), truth.location()),
          std::abs(angle_difference(truth.a, estimate.a))};
}

}  // namespace

void WorldScorer::take(const pico::truth_t& truth) {
  if (!first_in_world_ || truth.session != session_) {
    session_ = truth.session;
    first_in_world_ = to_model(truth.robot_in_world);
  } else if (!truths_.empty()) {
    score_.driven += distance(to_model(truths_.back().robot_in_world).location(),
                              to_model(truth.robot_in_world).location());
  }
  truths_.push_back(truth);
  if (truths_.size() > kKept) truths_.pop_front();

  const auto map = std::ranges::find_if(early_, [&](const auto& m) { return same_scan(truth, m); });
  if (map == early_.end()) return;
  compare(truth, *map);
  early_.erase(early_.begin(), map + 1);
}

void WorldScorer::take_world(const pico::map_t& message) {
  const Map world = to_model(message);
  if (message.part == 0) {
    walls_.clear();
    for (auto& [id, opening] : openings_) opening.is_open = false;
  }
  for (const Object& object : world.objects) {
    const bool is_open_door = object.type == ObjectType::door && object.reason != "shut";
    if (!is_open_door) {
      for (const Segment& edge : edges(world, object)) walls_.push_back(edge);
      continue;
    }
    Opening& opening = openings_[object.id];
    opening.segment = segment(world, object);
    opening.is_open = true;
  }
}

WorldScorer::Opening* WorldScorer::opening_at(const Segment& found) {
  for (auto& [id, opening] : openings_)
    if (opening.is_open &&
        distance(middle(opening.segment), middle(found)) < parameters_.max_door_offset)
      return &opening;
  return nullptr;
}

void WorldScorer::take_identified(const pico::map_t& map) {
  const auto truth =
      std::ranges::find_if(truths_, [&](const auto& t) { return same_scan(t, map); });
  if (truth != truths_.end()) return compare(*truth, map);
  early_.push_back(map);
  if (early_.size() > kKept) early_.pop_front();
}

void WorldScorer::compare(const pico::truth_t& truth, const pico::map_t& message) {
  if (walls_.empty()) return;
  const Position robot_in_world = to_model(truth.robot_in_world);
  const Map map = to_model(message);
  ++score_.maps;
  for (const Object& object : map.objects) {
    if (object.points.size() != 2) continue;
    const Segment in_world = transform(robot_in_world, segment(map, object));
    if (object.type == ObjectType::wall) {
      ++score_.walls;
      score_.walls_right += is_on_a_wall(in_world, walls_, parameters_.on_a_wall) ? 1 : 0;
    } else if (object.type == ObjectType::door) {
      ++score_.doors;
      if (Opening* opening = opening_at(in_world)) {
        ++score_.doors_right;
        opening->is_found = true;
      }
    }
  }
  const Position robot_in_start = relative(*first_in_world_, robot_in_world);
  score_.odometry_at_end = error_between(to_model(message.robot_in_zero), robot_in_start);
  score_.merge_at_end = error_between(to_model(message.robot_in_local), robot_in_start);
}

std::optional<WorldScore> WorldScorer::score() const {
  if (score_.maps == 0) return std::nullopt;
  WorldScore score = score_;
  score.openings = openings_.size();
  score.openings_found = static_cast<std::size_t>(
      std::ranges::count_if(openings_, [](const auto& entry) { return entry.second.is_found; }));
  return score;
}

}  // namespace perceptor
