#include "tools/eval/localize/site.hpp"

#include <algorithm>

#include "common/global_map/global_map.hpp"

namespace perceptor {
namespace {

constexpr double kThickestWall = 0.5;  // [m]
constexpr double kSameOpening = 0.05;  // [m] between the middles of one opening drawn twice

bool is_drawn_twice(const Segment& s, const Segment& t) {
  return distance(middle(s), middle(t)) < kSameOpening;
}

/// [m] to the opening in the other face of the same wall, which looks the other way.
double thickness(const Segment& opening, const std::vector<Segment>& openings) {
  double thickness = kThickestWall;
  for (const Segment& other : openings) {
    const bool looks_away = direction(opening).dot(direction(other)) < -0.9;
    if (!looks_away || is_drawn_twice(opening, other)) continue;
    const Vector2 step = middle(other) - middle(opening);
    const double aside = std::abs(step.dot(direction(opening)));
    const double behind = -signed_distance(opening, middle(other));
    if (aside < length(opening) / 2.0 && behind > 0.0) thickness = std::min(thickness, behind);
  }
  return thickness;
}

Segment set_back(const Segment& opening, double recess) {
  const Vector2 back = -recess * perpendicular(direction(opening));
  return {opening.a + back, opening.b + back};
}

}  // namespace

Site read_site(const std::filesystem::path& file) {
  Floorplan plan = read_floorplan(file);
  localize::World world(global_map::make_global_map(plan).map);
  std::vector<Segment> openings;
  for (const localize::Front& front : world.fronts())
    for (const Interval& gap : front.gaps)
      openings.push_back({point_at(front.line, gap.from), point_at(front.line, gap.to)});
  for (const auto& door : plan.doors) {
    const Segment drawn = plan.segment(door.front());
    const auto is_known = [&](const Segment& opening) { return is_drawn_twice(opening, drawn); };
    if (std::ranges::none_of(openings, is_known)) openings.push_back(drawn);
  }
  return {file.stem().string(), file, std::move(plan), std::move(world), std::move(openings)};
}

std::vector<Segment> lines(const Floorplan& plan) {
  std::vector<Segment> lines;
  for (const Floorplan::Edge& wall : plan.walls) lines.push_back(plan.segment(wall));
  for (const auto& cabinet : plan.cabinets)
    for (const Floorplan::Edge& side : cabinet) lines.push_back(plan.segment(side));
  return lines;
}

std::vector<Segment> leaves(const std::vector<Segment>& openings, double recess) {
  std::vector<Segment> leaves;
  for (const Segment& opening : openings) {
    const double most = thickness(opening, openings) / 2.0;
    const Segment leaf = set_back(opening, std::min(recess, most));
    const auto is_known = [&](const Segment& other) { return is_drawn_twice(leaf, other); };
    if (std::ranges::none_of(leaves, is_known)) leaves.push_back(leaf);
  }
  // The two faces of a thin wall have their opening at one place: one leaf, set back from one.
  std::vector<Segment> apart;
  for (const Segment& leaf : leaves) {
    const auto is_same_door = [&](const Segment& other) {
      return distance(middle(leaf), middle(other)) < 2.5 * recess &&
             std::abs(direction(leaf).dot(direction(other))) > 0.9;
    };
    if (recess == 0.0 || std::ranges::none_of(apart, is_same_door)) apart.push_back(leaf);
  }
  return apart;
}

}  // namespace perceptor
