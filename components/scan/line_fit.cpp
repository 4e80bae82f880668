#include "components/scan/line_fit.hpp"

#include <algorithm>
#include <cmath>

namespace perceptor::scan {
namespace {

/// Second moments about the mean, of unit weight.
struct Spread {
  double mean_x, mean_y;
  double xx, xy, yy;
};

Spread spread_of(const Moments& m) {
  const double mean_x = m.x / m.w;
  const double mean_y = m.y / m.w;
  return {.mean_x = mean_x,
          .mean_y = mean_y,
          .xx = m.xx / m.w - mean_x * mean_x,
          .xy = m.xy / m.w - mean_x * mean_y,
          .yy = m.yy / m.w - mean_y * mean_y};
}

}  // namespace

Moments operator+(const Moments& a, const Moments& b) {
  return {.beams = a.beams + b.beams,
          .w = a.w + b.w,
          .x = a.x + b.x,
          .y = a.y + b.y,
          .xx = a.xx + b.xx,
          .xy = a.xy + b.xy,
          .yy = a.yy + b.yy};
}

Moments operator-(const Moments& a, const Moments& b) {
  return {.beams = a.beams - b.beams,
          .w = a.w - b.w,
          .x = a.x - b.x,
          .y = a.y - b.y,
          .xx = a.xx - b.xx,
          .xy = a.xy - b.xy,
          .yy = a.yy - b.yy};
}

PrefixMoments::PrefixMoments(const Beams& beams) {
  sums_.reserve(beams.beams.size() + 1);
  sums_.emplace_back();
  for (const Beam& beam : beams.beams) {
    const double root = beam.range / beam.sigma;
    const double w = root * root;
    const double x = beam.location.x() - beams.laser.x();
    const double y = beam.location.y() - beams.laser.y();
    sums_.push_back(sums_.back() + Moments{.beams = 1.0,
                                           .w = w,
                                           .x = w * x,
                                           .y = w * y,
                                           .xx = w * x * x,
                                           .xy = w * x * y,
                                           .yy = w * y * y});
  }
}

Line make_line(const Vector2& point, const Vector2& direction, const Vector2& laser) {
  const bool runs_counter_clockwise = cross(point - laser, direction) >= 0.0;
  const Vector2 directed = runs_counter_clockwise ? direction : Vector2(-direction);
  return {.point = point, .direction = directed, .normal = perpendicular(directed)};
}

Line fit_line(const Moments& moments, const Vector2& laser) {
  const Spread s = spread_of(moments);
  const double angle = 0.5 * std::atan2(2.0 * s.xy, s.xx - s.yy);
  const Vector2 mean = laser + Vector2(s.mean_x, s.mean_y);
  return make_line(mean, Vector2(std::cos(angle), std::sin(angle)), laser);
}

Misfit misfit(const Moments& moments, const NoiseParameters& noise) {
  const Spread s = spread_of(moments);
  const double difference = s.xx - s.yy;
  const double root = std::sqrt(difference * difference + 4.0 * s.xy * s.xy);
  const double spread_across = std::max(0.0, 0.5 * (s.xx + s.yy - root));
  // Squared distance of the laser from the line, by the double angle of its direction.
  const double cos2 = root > 0.0 ? difference / root : 1.0;
  const double sin2 = root > 0.0 ? 2.0 * s.xy / root : 0.0;
  const double xx = s.mean_x * s.mean_x;
  const double yy = s.mean_y * s.mean_y;
  const double distance_squared =
      std::max(0.0, 0.5 * (xx + yy - cos2 * (xx - yy) - 2.0 * sin2 * s.mean_x * s.mean_y));
  const double roughness = noise.surface_roughness * noise.surface_roughness;
  const double variance = distance_squared * moments.beams / moments.w + roughness;
  return {.chi_square = variance > 0.0 ? moments.beams * spread_across / variance : 0.0,
          .variance = variance};
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
