#include "components/bridge/sim/laser.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "common/geometry/angle.hpp"

namespace perceptor::sim {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Beams that are looked at together are at most so far apart [rad]: one look at all obstacles
/// leaves a few for many beams.
constexpr double fan_angle = 0.25;

/// Rounding of a sum of beam times, far below the time between two beams [s].
constexpr double time_tolerance = 1e-9;

/// As perceptor::cross, in place: it is asked some millions of times a second.
inline double cross_of(const Vector2& a, const Vector2& b) {
  return (a.x() * b.y()) - (a.y() * b.x());
}

/// Distance along the ray to a segment; infinite where it misses.
double distance_along(const Vector2& origin, const Vector2& direction, const Segment& segment) {
  const Vector2 along = segment.b - segment.a;
  const Vector2 to_segment = segment.a - origin;
  const double denominator = cross_of(direction, along);
  if (denominator == 0.0) return infinity;
  const double on_segment = cross_of(to_segment, direction) / denominator;
  if (on_segment < 0.0 || on_segment > 1.0) return infinity;
  const double on_ray = cross_of(to_segment, along) / denominator;
  return on_ray >= 0.0 ? on_ray : infinity;
}

/// Distance along the ray to a circle, from inside to its far side; infinite where it misses.
double distance_along(const Vector2& origin, const Vector2& direction, const Circle& circle) {
  const Vector2 to_centre = circle.centre - origin;
  const double nearest = to_centre.dot(direction);
  const double half_chord_squared =
      (circle.radius * circle.radius) - to_centre.squaredNorm() + (nearest * nearest);
  if (half_chord_squared < 0.0) return infinity;
  const double half_chord = std::sqrt(half_chord_squared);
  if (nearest - half_chord >= 0.0) return nearest - half_chord;
  return nearest + half_chord >= 0.0 ? nearest + half_chord : infinity;
}

double nearest_along(const Vector2& origin, const Vector2& direction,
                     const std::vector<Segment>& segments, const std::vector<Circle>& legs) {
  double nearest = infinity;
  for (const Segment& segment : segments)
    nearest = std::min(nearest, distance_along(origin, direction, segment));
  for (const Circle& leg : legs)
    nearest = std::min(nearest, distance_along(origin, direction, leg));
  return nearest;
}

Vector2 heading(double bearing) { return {std::cos(bearing), std::sin(bearing)}; }

}  // namespace

double angle_increment(const LaserParameters& parameters) {
  if (parameters.beams < 2) return 0.0;
  return (parameters.angle_max - parameters.angle_min) / (parameters.beams - 1);
}

double time_increment(const LaserParameters& parameters) {
  return parameters.beams < 2 ? 0.0 : parameters.sweep_time / (parameters.beams - 1);
}

double cast_ray(const Vector2& origin, double bearing, const Obstacles& obstacles) {
  return nearest_along(origin, heading(bearing), obstacles.segments, obstacles.legs);
}

Laser::Laser(const LaserParameters& parameters, std::uint64_t seed)
    : parameters_(parameters),
      noise_random_(make_stream(seed, Stream::range_noise)),
      outlier_random_(make_stream(seed, Stream::outliers)),
      missed_random_(make_stream(seed, Stream::missed_beams)),
      missed_value_random_(make_stream(seed, Stream::missed_values)) {
  ranges_.reserve(static_cast<std::size_t>(parameters_.beams));
}

void Laser::sweep(const Stretch& stretch, const Obstacles& obstacles) {
  const Path path = laser_path(stretch);
  const double seconds_per_beam = time_increment(parameters_);
  const double radians_per_beam = angle_increment(parameters_);
  const auto beams = static_cast<std::size_t>(parameters_.beams);
  const auto is_in_stretch = [&](std::size_t beam) {
    const double time = static_cast<double>(beam) * seconds_per_beam;
    return beam < beams && time <= stretch.to + time_tolerance;
  };
  const auto beams_per_fan =
      radians_per_beam > 0.0
          ? std::max<std::size_t>(1, static_cast<std::size_t>(fan_angle / radians_per_beam))
          : 1;
  while (is_in_stretch(ranges_.size())) {
    const std::size_t first = ranges_.size();
    std::size_t last = first;
    while (last - first + 1 < beams_per_fan && is_in_stretch(last + 1)) ++last;
    measure(first, last, path, obstacles);
  }
}

Laser::Path Laser::laser_path(const Stretch& stretch) const {
  const Position at_from = compose(stretch.robot_in_world_from, parameters_.laser_in_robot);
  const Position at_to = compose(stretch.robot_in_world_to, parameters_.laser_in_robot);
  return {stretch.from, stretch.to, at_from, at_to, angle_difference(at_from.a, at_to.a)};
}

Laser::Ray Laser::ray(std::size_t beam, const Path& path) const {
  const auto number = static_cast<double>(beam);
  const double time = number * time_increment(parameters_);
  const double fraction = (time - path.from) / (path.to - path.from);
  const Vector2 from = path.laser_at_from.location();
  const Vector2 to = path.laser_at_to.location();
  const double bearing = parameters_.angle_min + (number * angle_increment(parameters_));
  return {from + (fraction * (to - from)),
          heading(path.laser_at_from.a + (fraction * path.turn) + bearing)};
}

void Laser::measure(std::size_t first, std::size_t last, const Path& path,
                    const Obstacles& obstacles) {
  // The outer rays bound a fan that is much narrower than a half turn. What lies on the outer
  // side of one of them, seen from both ends of the laser's way, is hit by no ray between.
  Ray lower = ray(first, path);
  Ray upper = ray(last, path);
  const bool turns_faster_than_sweep = cross(lower.direction, upper.direction) < 0.0;
  if (turns_faster_than_sweep) std::swap(lower, upper);
  const auto is_right_of_fan = [&](const Vector2& point, double margin) {
    return cross(lower.direction, point - lower.origin) < -margin &&
           cross(lower.direction, point - upper.origin) < -margin;
  };
  const auto is_left_of_fan = [&](const Vector2& point, double margin) {
    return cross(upper.direction, point - lower.origin) > margin &&
           cross(upper.direction, point - upper.origin) > margin;
  };
  std::vector<Segment> segments;
  for (const Segment& segment : obstacles.segments) {
    const bool misses = (is_right_of_fan(segment.a, 0.0) && is_right_of_fan(segment.b, 0.0)) ||
                        (is_left_of_fan(segment.a, 0.0) && is_left_of_fan(segment.b, 0.0));
    if (!misses) segments.push_back(segment);
  }
  std::vector<Circle> legs;
  for (const Circle& leg : obstacles.legs) {
    const bool misses =
        is_right_of_fan(leg.centre, leg.radius) || is_left_of_fan(leg.centre, leg.radius);
    if (!misses) legs.push_back(leg);
  }
  for (std::size_t beam = first; beam <= last; ++beam) {
    const Ray r = ray(beam, path);
    ranges_.push_back(
        static_cast<float>(reported(nearest_along(r.origin, r.direction, segments, legs))));
  }
}

double Laser::reported(double distance) {
  if (distance > parameters_.range_max) return missed_value();

  // Each stream is drawn from once for each return, whatever becomes of it.
  double range = distance;
  if (parameters_.noise_sigma > 0.0) {
    const double half_width = std::numbers::sqrt3 * parameters_.noise_sigma;
    range += parameters_.noise == NoiseKind::gaussian
                 ? parameters_.noise_sigma * normal_(noise_random_)
                 : std::uniform_real_distribution<double>(-half_width, half_width)(noise_random_);
  }
  std::uniform_real_distribution<double> share(0.0, 1.0);
  if (parameters_.outliers > 0.0) {
    const bool is_outlier = share(outlier_random_) < parameters_.outliers;
    const double anywhere = std::uniform_real_distribution<double>(
        parameters_.valid_min, parameters_.valid_max)(outlier_random_);
    if (is_outlier) range = anywhere;
  }
  const bool is_lost = parameters_.missed > 0.0 && share(missed_random_) < parameters_.missed;
  if (is_lost || range > parameters_.range_max) return missed_value();
  return range;
}

double Laser::missed_value() {
  switch (parameters_.missed_value) {
    case MissedValue::zero:
      return 0.0;
    case MissedValue::nan:
      return std::numeric_limits<double>::quiet_NaN();
    case MissedValue::range_max:
      return parameters_.range_max;
    case MissedValue::range_max_noise:
      return parameters_.range_max +
             std::uniform_real_distribution<double>(-parameters_.missed_noise,
                                                    parameters_.missed_noise)(missed_value_random_);
    case MissedValue::negative:
      return -1.0;
    case MissedValue::inf:
      break;
  }
  return infinity;
}

std::vector<float> Laser::take_ranges() {
  std::vector<float> ranges;
  ranges.reserve(static_cast<std::size_t>(parameters_.beams));
  ranges.swap(ranges_);
  return ranges;
}

}  // namespace perceptor::sim
