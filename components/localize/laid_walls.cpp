#include "components/localize/laid_walls.hpp"

#include <algorithm>
#include <cmath>

namespace perceptor::localize {
namespace {

constexpr double kGreaterPart = 0.5;

double length_on_fronts(const World& world, const Line& line, const LayTolerance& tolerance) {
  double most = 0.0;
  world.for_fronts_along(angle(line.along), tolerance.max_angle, [&](const Front& front) {
    const double offset = front.line.normal.dot(line.middle - front.line.middle);
    if (std::abs(offset) < tolerance.max_offset) most = std::max(most, length_on(front, line));
  });
  return most;
}

}  // namespace

Line transform(const Position& frame_in_new, const Line& line) {
  Line moved = line;
  moved.middle = perceptor::transform(frame_in_new, line.middle);
  moved.along = perceptor::transform({0.0, 0.0, frame_in_new.a}, line.along);
  moved.normal = perpendicular(moved.along);
  return moved;
}

double length_on(const Front& front, const Line& line) {
  const Interval extent = extent_on(front.line, line);
  double covered = 0.0;
  for (const auto* pieces : {&front.pieces, &front.gaps})
    for (const Interval& piece : *pieces)
      covered += std::max(0.0, common_part(piece, extent).length());
  return std::min(covered, line.length);
}

double explained_length(const World& world, const std::vector<LocalWall>& walls,
                        const Position& local_in_world, const LayTolerance& tolerance) {
  double explained = 0.0;
  for (const LocalWall& wall : walls)
    explained += length_on_fronts(world, transform(local_in_world, wall.line), tolerance);
  return explained;
}

double strange_length(const World& world, const std::vector<LocalWall>& walls,
                      const Position& local_in_world, const LayTolerance& tolerance,
                      double long_wall) {
  double strange = 0.0;
  for (const LocalWall& wall : walls) {
    const double length = wall.line.length;
    if (length < long_wall) continue;
    const double on_map = length_on_fronts(world, transform(local_in_world, wall.line), tolerance);
    if (on_map < kGreaterPart * length) strange += length - on_map;
  }
  return strange;
}

}  // namespace perceptor::localize
