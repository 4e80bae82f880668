#include "tools/eval/localize/site.hpp"

#include <utility>

#include "common/global_map/global_map.hpp"

namespace perceptor {
namespace {

Segment shifted(const Segment& segment, double to_the_left) {
  const Vector2 step = to_the_left * perpendicular(direction(segment));
  return {segment.a + step, segment.b + step};
}

}  // namespace

Site read_site(const std::filesystem::path& file) {
  Floorplan plan = read_floorplan(file);
  localize::World world(global_map::make_global_map(plan).map);
  return {file.stem().string(), file, std::move(plan), std::move(world)};
}

std::vector<Segment> lines(const Floorplan& plan) {
  std::vector<Segment> lines;
  for (const Floorplan::Edge& wall : plan.walls) lines.push_back(plan.segment(wall));
  for (const auto& cabinet : plan.cabinets)
    for (const Floorplan::Edge& side : cabinet) lines.push_back(plan.segment(side));
  return lines;
}

std::vector<Segment> flush_leaves(const localize::Doorway& doorway) {
  if (doorway.half_depth == 0.0) return {doorway.opening};
  return {shifted(doorway.opening, doorway.half_depth),
          shifted(doorway.opening, -doorway.half_depth)};
}

Segment recessed_leaf(const localize::Doorway& doorway, double recess) {
  return doorway.half_depth == 0.0 ? shifted(doorway.opening, recess) : doorway.opening;
}

}  // namespace perceptor
