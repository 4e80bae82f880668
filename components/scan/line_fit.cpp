#include "components/scan/line_fit.hpp"

namespace perceptor::scan {

void PrefixMoments::sum(const Beams& beams) {
  const std::size_t count = beams.is_circle ? 2 * beams.count : beams.count;
  sums_.resize(count + 1);
  Sums sum{};
  sums_[0] = sum;
  for (std::size_t i = 0; i < count; ++i) {
    const double w = beams.weight[i];
    const double x = beams.x[i];
    const double y = beams.y[i];
    const double wx = w * x;
    const double wy = w * y;
    sum = {sum.w + w, sum.x + wx, sum.y + wy, sum.xx + wx * x, sum.xy + wx * y, sum.yy + wy * y};
    sums_[i + 1] = sum;
  }
}

Line make_line(const PolarLine& line, const Vector2& laser) {
  const double distance = line.distance();
  const Vector2 normal(-line.a * distance, -line.b * distance);
  // A quarter turn clockwise from the normal: to the left of this direction is the laser.
  const Vector2 direction(normal.y(), -normal.x());
  return {.point = laser - distance * normal, .direction = direction, .normal = normal};
}

double offset(const Line& line, const Vector2& point) {
  return line.normal.dot(point - line.point);
}

Vector2 intersection(const Line& first, const Line& second) {
  const double along = cross(second.point - first.point, second.direction) /
                       cross(first.direction, second.direction);
  return first.point + along * first.direction;
}

}  // namespace perceptor::scan
