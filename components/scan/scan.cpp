#include "components/scan/scan.hpp"

#include <algorithm>
#include <utility>

#include "components/scan/angle_clustering.hpp"
#include "components/scan/corners.hpp"

namespace perceptor::scan {
namespace {

std::vector<std::size_t> cut_at_corners(const Beams& beams, const Run& stretch,
                                        const ScanParameters& parameters) {
  switch (parameters.method) {
    case ScanMethod::angle_clustering:
      return angle_clusters(beams, stretch.begin, stretch.end, parameters.cluster);
  }
  return {stretch.begin};
}

std::vector<Run> find_runs(const Beams& beams, const PrefixMoments& sums,
                           const ScanParameters& parameters) {
  std::vector<Run> runs;
  for (const Run& stretch : split_at_gaps(beams, sums)) {
    const std::vector<std::size_t> begins = cut_at_corners(beams, stretch, parameters);
    for (std::size_t i = 0; i < begins.size(); ++i) {
      const std::size_t end = i + 1 < begins.size() ? begins[i + 1] : stretch.end;
      runs.push_back(make_run(sums, begins[i], end));
    }
  }
  return refine(std::move(runs), beams, sums, parameters);
}

Point make_point(const WallEnd& end, CornerMethod method, double radius) {
  Point point;
  point.location = end.location;
  point.covariance = end.covariance;
  point.method = method;
  point.radius = radius;
  point.weight = 2.0 / end.covariance.trace();
  return point;
}

void add_wall(Map& map, const Wall& wall, const WallCorners& corners, double radius) {
  const Index index = add_segment(map, {wall.first.location, wall.last.location}, ObjectType::wall);
  Object& object = map.objects[static_cast<std::size_t>(index)];
  object.free_side = FreeSide::left;
  object.support = wall.support;
  object.line_covariance = wall.line_covariance;
  object.weight = 1.0 / wall.line_covariance(0, 0);
  const auto set_point = [&](Index point, const WallEnd& end, CornerMethod method) {
    Point& target = map.points[static_cast<std::size_t>(point)];
    const std::vector<Index> parents = target.parents;
    target = make_point(end, method, radius);
    target.parents = parents;
  };
  set_point(object.points[0], wall.first, corners.first);
  set_point(object.points[1], wall.last, corners.last);
}

}  // namespace

CurrentMap extract_walls(const LaserScan& scan, const Twist& twist,
                         const std::vector<Vector2>& footprint, const ScanParameters& parameters) {
  const Beams beams = usable_beams(scan, twist, footprint, parameters);
  CurrentMap current;
  current.no_return = beams.no_return;
  current.in_footprint = beams.in_footprint;

  const PrefixMoments sums(beams);
  const std::vector<Run> runs = find_runs(beams, sums, parameters);
  std::vector<std::optional<Wall>> walls;
  for (const Run& run : runs) walls.push_back(fit_wall(run, beams, parameters));
  const Corners corners = find_corners(runs, walls, beams, parameters);

  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < walls.size(); ++i)
    if (walls[i]) order.push_back(i);
  std::ranges::stable_sort(order, {},
                           [&](std::size_t i) { return beams[walls[i]->first_beam].bearing; });
  const double radius = parameters.corner.connection_radius;
  for (const std::size_t i : order) add_wall(current.map, *walls[i], corners.of_walls[i], radius);
  for (const LoneCorner& corner : corners.lone)
    current.map.points.push_back(make_point(corner.place, corner.method, radius));
  return current;
}

}  // namespace perceptor::scan
