#include "components/localize/world.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace perceptor::localize {
namespace {

constexpr double kSameLine = 0.02;    // [m] faces are drawn to the millimetre or the centimetre
constexpr double kSameAngle = 0.02;   // [rad]
constexpr double kSameOpening = 0.3;  // [rad] the faces of a wall need not be parallel

bool is_in_line(const Front& front, const Line& line) {
  return front.line.along.dot(line.along) > std::cos(kSameAngle) &&
         std::abs(front.line.normal.dot(line.middle - front.line.middle)) < kSameLine;
}

}  // namespace

World::World(const Map& global_map, const WorldParameters& parameters) {
  std::vector<Segment> drawn_doors;
  for (std::size_t i = 0; i < global_map.objects.size(); ++i) {
    const Object& object = global_map.objects[i];
    if (object.type == ObjectType::wall && object.points.size() == 2) {
      const Segment wall = segment(global_map, object);
      if (object.free_side != FreeSide::right) add_face(wall, i, true);
      if (object.free_side != FreeSide::left) add_face({wall.b, wall.a}, i, true);
    } else if (object.type == ObjectType::cabinet && object.points.size() > 2) {
      for (const Segment& side : edges(global_map, object)) add_face(side, i, false);
    } else if (object.type == ObjectType::door && object.points.size() == 2) {
      drawn_doors.push_back(segment(global_map, object));
    }
  }
  rays_.sort();
  for (Front& front : fronts_) find_gaps(front, parameters);
  find_doorways(drawn_doors, parameters);
  rays_.sort();
  for (std::size_t i = 0; i < fronts_.size(); ++i) {
    Front& front = fronts_[i];
    for (const auto* pieces : {&front.pieces, &front.gaps})
      for (const Interval& piece : *pieces) front.length += piece.length();
    by_angle_.emplace_back(std::atan2(front.line.along.y(), front.line.along.x()), i);
  }
  std::ranges::sort(by_angle_);
}

/// Many maps draw no doors, only the gaps for them.
void World::find_gaps(Front& front, const WorldParameters& parameters) {
  std::ranges::sort(front.pieces, {}, &Interval::from);
  std::ranges::sort(front.walls, {}, &Interval::from);
  if (front.walls.empty()) return;
  double reached = front.walls.front().to;
  for (const Interval& piece : front.walls) {
    const Interval gap{reached, piece.from};
    if (is_doorway(front, gap, parameters)) front.gaps.push_back(gap);
    reached = std::max(reached, piece.to);
  }
}

void World::find_doorways(const std::vector<Segment>& drawn, const WorldParameters& parameters) {
  for (const Segment& door : drawn) {
    rays_.add_opening(door);
    if (!join_doorway(door, parameters)) doorways_.push_back({door, 0.0});
  }
  for (const Front& front : fronts_)
    for (const Interval& gap : front.gaps) {
      const Segment opening{point_at(front.line, gap.from), point_at(front.line, gap.to)};
      rays_.add_opening(opening);
      if (!join_doorway(opening, parameters) && drawn.empty()) doorways_.push_back({opening, 0.0});
    }
}

bool World::is_doorway(const Front& front, const Interval& gap,
                       const WorldParameters& parameters) const {
  if (gap.length() < parameters.min_door || gap.length() > parameters.max_door) return false;
  const Vector2& along = front.line.along;
  const Vector2 place = point_at(front.line, gap.middle());
  return rays_.first(place, -front.line.normal).distance > parameters.behind &&
         !runs_into(point_at(front.line, gap.from), along, parameters) &&
         !runs_into(point_at(front.line, gap.to), -along, parameters);
}

/// Whether a wall goes on from the end of a gap, across it. `gap`: from there, unit vector.
bool World::runs_into(const Vector2& end, const Vector2& gap,
                      const WorldParameters& parameters) const {
  return std::ranges::any_of(faces_, [&](const Face& face) {
    const bool begins = distance(face.segment.a, end) < kSameLine;
    const bool ends = distance(face.segment.b, end) < kSameLine;
    const double towards = face.line.along.dot(gap);
    return (begins && towards > parameters.jamb) || (ends && -towards > parameters.jamb);
  });
}

/// What is open in both faces of a wall is one doorway.
bool World::join_doorway(const Segment& opening, const WorldParameters& parameters) {
  for (Doorway& known : doorways_) {
    const Vector2 along = direction(known.opening);
    const Vector2 step = middle(opening) - middle(known.opening);
    const double across = cross(along, step);
    const double smallest = std::min(length(opening), length(known.opening));
    const bool is_in_same_wall = std::abs(along.dot(direction(opening))) > std::cos(kSameOpening) &&
                                 std::abs(across) < parameters.max_wall &&
                                 std::abs(along.dot(step)) < smallest / 2.0;
    if (!is_in_same_wall) continue;
    if (std::abs(across) > 2.0 * known.half_depth + kSameLine) {
      const Vector2 inward = across / 2.0 * perpendicular(along);
      known.opening = {known.opening.a + inward, known.opening.b + inward};
      known.half_depth = std::abs(across) / 2.0;
    }
    return true;
  }
  return false;
}

void World::add_face(const Segment& segment, std::size_t object, bool is_wall) {
  const Line line = line_of(segment);
  faces_.push_back({segment, line, object});
  rays_.add(segment);
  auto front =
      std::ranges::find_if(fronts_, [&](const Front& known) { return is_in_line(known, line); });
  if (front == fronts_.end()) front = fronts_.insert(front, Front{line, {}, {}, {}, 0.0});
  const Interval extent = extent_on(front->line, line);
  front->pieces.push_back(extent);
  if (is_wall) front->walls.push_back(extent);
}

const Face* World::nearest_face(const Vector2& place, const Vector2& direction, double reach,
                                double min_cosine) const {
  const Face* nearest = nullptr;
  double least = reach;
  rays_.for_lines_near(place, reach, [&](std::size_t line) {
    const Face& face = faces_[line];
    if (face.line.normal.dot(direction) < min_cosine) return;
    const double away = distance(face.segment, place);
    if (away >= least) return;
    nearest = &face;
    least = away;
  });
  return nearest;
}

Met World::meet(const Vector2& origin, const Vector2& direction, double range) const {
  const RayHit hit = rays_.first(origin, direction, range);
  return {hit.distance, hit.opening};
}

}  // namespace perceptor::localize
