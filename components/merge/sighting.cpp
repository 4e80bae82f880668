#include "components/merge/sighting.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace perceptor::merge {
namespace {

double square(double value) { return value * value; }

bool is_wall(const Object& object) {
  return object.type == ObjectType::wall && object.points.size() == 2;
}

WallEnd end_of(const Point& point, const Vector2& along, const SightingParameters& parameters) {
  WallEnd end;
  end.method = point.method;
  end.variance =
      square(parameters.end_sigma) + (point.covariance ? along.dot(*point.covariance * along)
                                                       : square(parameters.unknown_end_sigma));
  end.radius =
      point.radius > 0.0 ? std::min(point.radius, parameters.max_radius) : parameters.radius;
  return end;
}

Eigen::Matrix2d line_covariance(const Object& object, const SightingParameters& parameters) {
  const Eigen::Vector2d unknown(square(parameters.unknown_offset_sigma),
                                square(parameters.unknown_angle_sigma));
  const Eigen::Vector2d floor(square(parameters.offset_sigma), square(parameters.angle_sigma));
  Eigen::Matrix2d covariance =
      object.line_covariance ? *object.line_covariance : Eigen::Matrix2d(unknown.asDiagonal());
  covariance.diagonal() += floor;
  return covariance;
}

bool must_be_turned(const Object& object, const Segment& segment, const Vector2& viewpoint) {
  if (object.free_side == FreeSide::right) return true;
  return object.free_side == FreeSide::unknown && signed_distance(segment, viewpoint) < 0.0;
}

Wall sighted_wall(const Map& current, const Object& object, const Vector2& viewpoint,
                  std::int64_t utime, const SightingParameters& parameters) {
  Wall wall;
  wall.segment = segment(current, object);
  wall.covariance = line_covariance(object, parameters);
  const Vector2 along = direction(wall.segment);
  for (const std::size_t end : {kTail, kHead})
    wall.ends[end] =
        end_of(current.points[static_cast<std::size_t>(object.points[end])], along, parameters);
  wall.support = object.support;
  wall.first_seen = utime;
  wall.last_seen = utime;
  if (must_be_turned(object, wall.segment, viewpoint)) {
    std::swap(wall.segment.a, wall.segment.b);
    std::swap(wall.ends[kTail], wall.ends[kHead]);
    // The offset now counts to the other side, the angle as before.
    wall.covariance(0, 1) = -wall.covariance(0, 1);
    wall.covariance(1, 0) = -wall.covariance(1, 0);
  }
  return wall;
}

/// Longest first. The rest only decides between walls of one length.
bool comes_before(const Wall& p, const Wall& q) {
  const auto key = [](const Wall& wall) {
    const Vector2& a = wall.segment.a;
    const Vector2& b = wall.segment.b;
    return std::tuple(-length(wall.segment), angle(middle(wall.segment)), a.x(), a.y(), b.x(),
                      b.y(), wall.covariance(0, 0), wall.covariance(1, 1));
  };
  return key(p) < key(q);
}

}  // namespace

std::vector<Wall> sighted_walls(const Map& current, const Vector2& viewpoint, std::int64_t utime,
                                const SightingParameters& parameters) {
  std::vector<Wall> walls;
  for (const Object& object : current.objects)
    if (is_wall(object) && length(current, object) >= parameters.min_length)
      walls.push_back(sighted_wall(current, object, viewpoint, utime, parameters));
  std::sort(walls.begin(), walls.end(), comes_before);
  return walls;
}

Wall transform(const Position& robot_in_local, const Eigen::Matrix3d& pose_covariance,
               const Wall& wall) {
  Wall moved = wall;
  moved.segment = perceptor::transform(robot_in_local, wall.segment);
  const Line line = line_of(moved.segment);
  const Vector2 lever = perpendicular(line.middle - robot_in_local.location());
  Eigen::Matrix<double, 2, 3> by_pose;
  by_pose << line.normal.x(), line.normal.y(), line.normal.dot(lever), 0.0, 0.0, 1.0;
  moved.covariance += by_pose * pose_covariance * by_pose.transpose();
  return moved;
}

}  // namespace perceptor::merge
