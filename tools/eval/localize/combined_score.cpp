#include "tools/eval/localize/combined_score.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/geometry/angle.hpp"

namespace perceptor {
namespace {

Vector2 middle_of(const std::vector<Vector2>& outline) {
  Vector2 sum = Vector2::Zero();
  for (const Vector2& corner : outline) sum += corner;
  return sum / static_cast<double>(outline.size());
}

/// [m] 0 where one lies within the other.
double separation(const std::vector<Vector2>& p, const std::vector<Vector2>& q) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [some, others] : {std::pair{&p, &q}, std::pair{&q, &p}})
    for (const Vector2& corner : *some) {
      if (contains(*others, corner)) return 0.0;
      for (const Segment& edge : edges(*others)) least = std::min(least, distance(edge, corner));
    }
  return least;
}

}  // namespace

CombinedScore& CombinedScore::operator+=(const CombinedScore& other) {
  doors.hits += other.doors.hits;
  doors.cases += other.doors.cases;
  objects.hits += other.objects.hits;
  objects.cases += other.objects.cases;
  false_objects += other.false_objects;
  time += other.time;
  return *this;
}

void CombinedScorer::take(const Map& map, const sim::Truth& truth, double time) {
  if (last_ >= 0.0) score_.time += time - last_;
  last_ = time;
  note_people(truth, time);
  score_doors(map, truth.robot_in_world, time);
  score_objects(map, truth, time);
}

/// [s] in view, with short lapses.
double CombinedScorer::in_view_for(Looks& looks, std::size_t which, bool is_seen,
                                   double time) const {
  InView& look = looks[which];
  if (!is_seen) return 0.0;
  if (time - look.last > parameters_.lapse) look.since = time;
  look.last = time;
  return time - look.since;
}

/// A person who stays somewhere for a while is a thing like others.
void CombinedScorer::note_people(const sim::Truth& truth, double time) {
  people_.resize(truth.movers.size());
  for (std::size_t i = 0; i < people_.size(); ++i) {
    const Vector2& place = truth.movers[i].body.centre;
    if (distance(people_[i].place, place) > parameters_.person / 2.0) people_[i] = {place, time};
    if (time - people_[i].since >= parameters_.stands_after) stands_.push_back(people_[i]);
  }
}

/// A thing in a doorway makes it neither open nor shut.
bool CombinedScorer::is_blocked(const Segment& opening) const {
  return std::ranges::any_of(world_.boxes, [&](const sim::Box& box) {
    return separation(sim::outline(box), {opening.a, opening.b}) < parameters_.blocked;
  });
}

void CombinedScorer::score_doors(const Map& map, const Position& robot, double time) {
  std::vector<Segment> opaque = world_.walls;
  for (const sim::Box& box : world_.boxes)
    for (const Segment& side : edges(sim::outline(box))) opaque.push_back(side);
  const sim::Obstacles obstacles{opaque, {}, {}};
  for (const Object& door : map.objects) {
    if (door.type != ObjectType::door) continue;
    const Segment opening = segment(map, door);
    if (is_blocked(opening)) continue;
    const Vector2 to = middle(opening) - robot.location();
    const double bearing = std::atan2(to.y(), to.x());
    const double incidence = std::abs(cross(direction(opening), to)) / to.norm();
    // A shut leaf hides the middle itself.
    constexpr double kLeaf = 0.35;
    const bool is_seen = to.norm() < parameters_.within && incidence > parameters_.min_incidence &&
                         std::abs(angle_difference(robot.a, bearing)) < parameters_.half_view &&
                         sim::cast_ray(robot.location(), bearing, obstacles) > to.norm() - kLeaf;
    const double seen_for = in_view_for(doors_, static_cast<std::size_t>(door.id), is_seen, time);
    if (seen_for < parameters_.door_after) continue;
    score_.doors.add(door.reason == (doors_are_ == Doors::open ? "open" : "shut"));
  }
}

std::vector<int> CombinedScorer::rays_on_boxes(const Position& robot) const {
  std::vector<sim::Obstacles> boxes;
  for (const sim::Box& box : world_.boxes) boxes.push_back({edges(sim::outline(box)), {}, {}});
  const sim::Obstacles walls{world_.walls, {}, {}};
  std::vector<int> rays(boxes.size(), 0);
  for (int k = 0; k < parameters_.rays; ++k) {
    const double bearing =
        robot.a + parameters_.half_view * (2.0 * k / (parameters_.rays - 1) - 1.0);
    double nearest = std::min(parameters_.within, sim::cast_ray(robot.location(), bearing, walls));
    std::size_t first = boxes.size();
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      const double range = sim::cast_ray(robot.location(), bearing, boxes[i]);
      if (range >= nearest) continue;
      nearest = range;
      first = i;
    }
    if (first < boxes.size()) ++rays[first];
  }
  return rays;
}

void CombinedScorer::score_objects(const Map& map, const sim::Truth& truth, double time) {
  std::vector<std::vector<Vector2>> found;
  for (const Object& object : map.objects) {
    if (object.type != ObjectType::static_obstacle) continue;
    found.push_back(corners(map, object));
    const auto explains = [&](const sim::Box& box) {
      return separation(sim::outline(box), found.back()) < parameters_.object_error;
    };
    const auto stood_there = [&](const Stand& stand) {
      return distance(stand.place, middle_of(found.back())) < parameters_.person;
    };
    const bool is_real =
        std::ranges::any_of(world_.boxes, explains) || std::ranges::any_of(stands_, stood_there);
    if (!is_real && false_ids_.insert(object.id).second) ++score_.false_objects;
  }
  const std::vector<int> rays = rays_on_boxes(truth.robot_in_world);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const bool is_seen = rays[i] >= parameters_.object_rays;
    if (in_view_for(boxes_, i, is_seen, time) < parameters_.object_after) continue;
    const auto outline = sim::outline(world_.boxes[i]);
    score_.objects.add(std::ranges::any_of(found, [&](const std::vector<Vector2>& seen) {
      return separation(outline, seen) < parameters_.object_error;
    }));
  }
}

}  // namespace perceptor
