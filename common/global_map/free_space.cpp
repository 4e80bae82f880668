#include "common/global_map/free_space.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "common/floorplan/outline.hpp"
#include "common/geometry/polygon.hpp"
#include "common/global_map/disjoint_sets.hpp"
#include "common/global_map/openings.hpp"

namespace perceptor::global_map {
namespace {

std::vector<DrawnLine> lines_of(const Floorplan& plan) {
  std::vector<DrawnLine> lines;
  for (const Floorplan::Edge& wall : plan.walls)
    lines.push_back({plan.segment(wall), {.is_wall = true}});
  for (std::size_t i = 0; i < plan.cabinets.size(); ++i)
    for (const Floorplan::Edge& side : plan.cabinets[i])
      lines.push_back({plan.segment(side), {.cabinet = static_cast<int>(i)}});
  for (const auto& door : plan.doors)
    for (const Floorplan::Edge& edge : door)
      lines.push_back({plan.segment(edge), {.is_door = true}});
  return lines;
}

/// Rule 1.
Arrangement arrange(const Floorplan& plan, const FreeSpaceParameters& parameters) {
  std::vector<DrawnLine> lines = lines_of(plan);
  Arrangement drawn(node(lines, parameters.snap));
  const std::vector<Segment> closing_lines = closings(drawn, parameters.max_opening);
  if (closing_lines.empty()) return drawn;
  for (const Segment& line : closing_lines) lines.push_back({line, {.is_closing = true}});
  return Arrangement(node(lines, parameters.snap));
}

/// What is known of a face before its neighbours are.
struct FaceFacts {
  bool is_cabinet = false;
  bool has_start = false;
  bool has_opening = false;
  std::size_t region = 0;  ///< rule 2: one number for faces that belong together
};

bool is_inside_cabinet(const Vector2& place, const Floorplan& plan) {
  return std::ranges::any_of(
      plan.cabinets, [&](const auto& cabinet) { return contains(corners(plan, cabinet), place); });
}

void find_cabinets(const Arrangement& arrangement, const Floorplan& plan,
                   std::vector<FaceFacts>& facts) {
  std::vector<bool> is_looked_at(facts.size(), false);
  for (std::size_t h = 0; h < arrangement.half_edges(); ++h) {
    const std::size_t face = arrangement.face(h);
    const bool may_be = arrangement.kind(h).cabinet != kNoCabinet && face != kOutside;
    if (!may_be || is_looked_at[face]) continue;
    is_looked_at[face] = true;
    facts[face].is_cabinet = is_inside_cabinet(arrangement.place_beside(h), plan);
  }
}

/// A place within an outline [m]: off the middle of its first edge, on its inner side.
Vector2 place_within(const Floorplan& plan, const std::vector<Floorplan::Edge>& outline,
                     double snap) {
  std::vector<DrawnLine> lines;
  lines.reserve(outline.size());
  for (const Floorplan::Edge& edge : outline)
    lines.push_back({plan.segment(edge), {.is_wall = true}});
  const Arrangement alone(node(lines, snap));
  for (std::size_t h = 0; h < alone.half_edges(); ++h)
    if (alone.face(h) != kOutside) return alone.place_beside(h);
  return middle(plan.segment(outline.front()));
}

void find_starts(const Arrangement& arrangement, const Floorplan& plan, double snap,
                 std::vector<FaceFacts>& facts) {
  for (const auto& outline : plan.start_area)
    facts[arrangement.face_at(place_within(plan, outline, snap))].has_start = true;
}

void find_regions(const Arrangement& arrangement, std::vector<FaceFacts>& facts) {
  DisjointSets regions(facts.size());
  for (std::size_t h = 0; h < arrangement.half_edges(); h += 2) {
    const EdgeKind& kind = arrangement.kind(h);
    if (!kind.is_opening()) continue;
    const std::size_t left = arrangement.face(h);
    const std::size_t right = arrangement.face(twin(h));
    facts[left].has_opening = facts[right].has_opening = true;
    const bool leads_out = left == kOutside || right == kOutside;
    const bool is_of_cabinet = facts[left].is_cabinet || facts[right].is_cabinet;
    if (!is_of_cabinet && (kind.is_door || !leads_out)) regions.join(left, right);
  }
  for (std::size_t face = 0; face < facts.size(); ++face) facts[face].region = regions.find(face);
}

std::vector<FaceFacts> facts_of(const Arrangement& arrangement, const Floorplan& plan,
                                double snap) {
  std::vector<FaceFacts> facts(arrangement.faces().size());
  find_cabinets(arrangement, plan, facts);
  find_starts(arrangement, plan, snap, facts);
  find_regions(arrangement, facts);
  return facts;
}

/// What stands in something comes after it.
std::vector<std::size_t> from_outside_in(const std::vector<Face>& faces) {
  std::vector<int> depth(faces.size(), 0);
  for (std::size_t i = 0; i < faces.size(); ++i)
    for (std::size_t f = i; f != kOutside; f = faces[f].around) ++depth[i];
  std::vector<std::size_t> order(faces.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t face) { return depth[face]; });
  return order;
}

bool is_wide(const Face& face, double min_width) {
  return 2.0 * face.area >= min_width * face.perimeter;
}

/// Rules 3 to 5.
std::vector<bool> classify(const std::vector<Face>& faces, const std::vector<FaceFacts>& facts,
                           double min_width) {
  std::vector<bool> is_region_free(faces.size(), false);
  for (const FaceFacts& face : facts)
    if (face.has_start) is_region_free[face.region] = true;

  const auto is_face_free = [&](std::size_t face) {
    return !facts[face].is_cabinet && is_region_free[facts[face].region];
  };
  for (const std::size_t face : from_outside_in(faces)) {
    if (face == kOutside || facts[face].is_cabinet) continue;
    const std::size_t around = faces[face].around;
    const bool stands_in_solid = around == kOutside || !is_face_free(around);
    const bool is_room = is_wide(faces[face], min_width) || facts[face].has_opening;
    if (stands_in_solid && is_room) is_region_free[facts[face].region] = true;
  }

  std::vector<bool> is_free(faces.size());
  for (std::size_t face = 0; face < faces.size(); ++face) is_free[face] = is_face_free(face);
  if (std::ranges::find(is_free, true) == is_free.end()) is_free[kOutside] = true;
  return is_free;
}

}  // namespace

FreeSpace find_free_space(const Floorplan& plan, const FreeSpaceParameters& parameters) {
  Arrangement arrangement = arrange(plan, parameters);
  const std::vector<FaceFacts> facts = facts_of(arrangement, plan, parameters.snap);
  std::vector<bool> is_free = classify(arrangement.faces(), facts, parameters.min_width);
  return {std::move(arrangement), std::move(is_free)};
}

}  // namespace perceptor::global_map
