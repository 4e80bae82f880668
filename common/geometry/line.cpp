#include "common/geometry/line.hpp"

#include <cmath>

namespace perceptor {

Line line_of(const Segment& segment) {
  Line line;
  line.middle = middle(segment);
  line.along = direction(segment);
  line.normal = perpendicular(line.along);
  line.length = length(segment);
  return line;
}

double turn_between(const Line& from, const Line& to) {
  return std::atan2(cross(from.along, to.along), from.along.dot(to.along));
}

double place_on(const Line& line, const Vector2& point) {
  return line.along.dot(point - line.middle);
}

Vector2 point_at(const Line& line, double place) { return line.middle + place * line.along; }

Interval extent_of(const Line& line) { return {-line.length / 2.0, line.length / 2.0}; }

Interval extent_on(const Line& line, const Line& other) {
  const double centre = place_on(line, other.middle);
  const double half = std::abs(line.along.dot(other.along)) * other.length / 2.0;
  return {centre - half, centre + half};
}

}  // namespace perceptor
