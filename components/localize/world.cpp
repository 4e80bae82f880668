#include "components/localize/world.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace perceptor::localize {
namespace {

constexpr double kSameLine = 0.02;   // [m] faces are drawn to the millimetre or the centimetre
constexpr double kSameAngle = 0.02;  // [rad]

/// The sides of a closed object, in the order of its points.
std::vector<Segment> sides(const Map& map, const Object& object) {
  std::vector<Segment> sides;
  const auto location = [&](std::size_t i) {
    return map.points[static_cast<std::size_t>(object.points[i % object.points.size()])].location;
  };
  for (std::size_t i = 0; i < object.points.size(); ++i)
    sides.push_back({location(i), location(i + 1)});
  return sides;
}

bool is_in_line(const Front& front, const Line& line) {
  return front.line.along.dot(line.along) > std::cos(kSameAngle) &&
         std::abs(front.line.normal.dot(line.middle - front.line.middle)) < kSameLine;
}

}  // namespace

World::World(const Map& global_map, const WorldParameters& parameters) {
  for (const Object& object : global_map.objects) {
    if (object.type == ObjectType::wall && object.points.size() == 2) {
      const Segment wall = segment(global_map, object);
      if (object.free_side != FreeSide::right) add_face(wall);
      if (object.free_side != FreeSide::left) add_face({wall.b, wall.a});
    } else if (object.type == ObjectType::cabinet && object.points.size() > 2) {
      for (const Segment& side : sides(global_map, object)) add_face(side);
    } else if (object.type == ObjectType::door && object.points.size() == 2) {
      doors_.add(segment(global_map, object));
    }
  }
  for (Front& front : fronts_) find_gaps(front, parameters);
}

/// Many maps draw no doors, only the gaps for them.
void World::find_gaps(Front& front, const WorldParameters& parameters) {
  std::ranges::sort(front.pieces, {}, &Interval::from);
  double reached = front.pieces.front().to;
  for (const Interval& piece : front.pieces) {
    const Interval gap{reached, piece.from};
    if (gap.length() >= parameters.min_door && gap.length() <= parameters.max_door) {
      front.gaps.push_back(gap);
      doors_.add({point_at(front.line, gap.from), point_at(front.line, gap.to)});
    }
    reached = std::max(reached, piece.to);
  }
}

void World::add_face(const Segment& segment) {
  const Line line = line_of(segment);
  faces_.push_back({segment, line});
  solid_.add(segment);
  const auto front =
      std::ranges::find_if(fronts_, [&](const Front& known) { return is_in_line(known, line); });
  if (front == fronts_.end())
    fronts_.push_back({line, {extent_of(line)}, {}});
  else
    front->pieces.push_back(extent_on(front->line, line));
}

Met World::meet(const Vector2& origin, const Vector2& direction) const {
  Met met{solid_.nearest(origin, direction), doors_.nearest(origin, direction)};
  if (met.door >= met.face) met.door = std::numeric_limits<double>::infinity();
  return met;
}

void World::Rays::add(const Segment& segment) {
  ax.push_back(segment.a.x());
  ay.push_back(segment.a.y());
  dx.push_back(segment.b.x() - segment.a.x());
  dy.push_back(segment.b.y() - segment.a.y());
}

double World::Rays::nearest(const Vector2& origin, const Vector2& direction) const {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ax.size(); ++i) {
    const double to_x = ax[i] - origin.x();
    const double to_y = ay[i] - origin.y();
    const double across = direction.x() * dy[i] - direction.y() * dx[i];
    const double distance = (to_x * dy[i] - to_y * dx[i]) / across;
    const double place = (to_x * direction.y() - to_y * direction.x()) / across;
    const bool is_met = distance > 0.0 && place >= 0.0 && place <= 1.0;  // parallel: NaN, not met
    nearest = is_met ? std::min(nearest, distance) : nearest;
  }
  return nearest;
}

}  // namespace perceptor::localize
