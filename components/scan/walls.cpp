#include "components/scan/walls.hpp"

#include <algorithm>
#include <cmath>

namespace perceptor::scan {
namespace {

/// Fits after which the set of supporting beams has settled, or never will.
constexpr int kFits = 3;

/// The beams of a run that support a line.
struct Support {
  std::size_t first = 0;
  std::size_t last = 0;
  int count = 0;
  Moments moments;
  Vector2 sum{0.0, 0.0};  ///< [m] of where they end, from the laser
};

/// The best line through the beams. The weight of a beam grows with its range as measured, so
/// that beams which err outwards count for more: to first order the normal equations are off by
/// three times the sum of the beams, whatever the noise, and that is put back.
PolarLine unbiased_line(const Support& support) {
  constexpr double kBias = 3.0;
  Moments moments = support.moments;
  moments.x += kBias * support.sum.x();
  moments.y += kBias * support.sum.y();
  return polar_line(moments);
}

/// By how much the beams scatter more than the noise says: not straight, or not so precise.
double excess_of(const Moments& moments, const ScanParameters& parameters) {
  const double chi_square = misfit(moments, parameters.noise.surface_roughness).chi_square;
  const double degrees_of_freedom = std::max(1.0, moments.beams - 2.0);
  return std::clamp(chi_square / degrees_of_freedom, 1.0, parameters.wall.max_excess);
}

Eigen::Map<const Eigen::ArrayXd> of_run(const Run& run, const std::vector<double>& array) {
  return {array.data() + run.begin, static_cast<Eigen::Index>(run.size())};
}

/// Whether no beam of the run is further from the line than the limits allow: several beams at a
/// time, since mostly it is so.
bool all_support(const Run& run, const Beams& beams, const PolarLine& line, double limit,
                 double rough) {
  const auto x = of_run(run, beams.x);
  const auto y = of_run(run, beams.y);
  const auto weight = of_run(run, beams.weight);
  const auto off = line.a * x + line.b * y - 1.0;
  return ((off.square() - rough) * weight).maxCoeff() <= limit;
}

/// The beams of the run within some sigmas of the line, `excess` their variance over what the
/// noise says.
Support find_support(const Run& run, const Sweep& sweep, const PolarLine& line, double excess,
                     const ScanParameters& parameters) {
  const Beams& beams = sweep.beams;
  const double sigmas = parameters.wall.support_sigmas;
  const double limit = sigmas * sigmas * excess;
  const double roughness = parameters.noise.surface_roughness;
  const double rough = limit * roughness * roughness * (line.a * line.a + line.b * line.b);
  Support support{.first = run.begin,
                  .last = run.end - 1,
                  .count = static_cast<int>(run.size()),
                  .moments = sweep.sums.of(run.begin, run.end),
                  .sum = {of_run(run, beams.x).sum(), of_run(run, beams.y).sum()}};
  if (all_support(run, beams, line, limit, rough)) return support;
  support.count = 0;
  for (std::size_t i = run.begin; i < run.end; ++i) {
    const double off = line.a * beams.x[i] + line.b * beams.y[i] - 1.0;
    if ((off * off - rough) * beams.weight[i] > limit) {
      support.moments = support.moments - moments_of(beams, i);
      support.sum -= beams.end(i);
      continue;
    }
    if (support.count++ == 0) support.first = i;
    support.last = i;
  }
  return support;
}

/// Inverse of the information that the beams hold about offset and angle of their line, at a
/// place that is `along` [m] on it from where it is nearest to the laser.
Eigen::Matrix2d covariance_at(double along, const Vector2& direction, const Moments& m,
                              const Misfit& fit, double excess) {
  // Of a beam, the inverse variance across the line is its weight times this.
  const double information = m.beams / (m.w * fit.variance);
  const double mean = (direction.x() * m.x + direction.y() * m.y) / m.w;
  const double second = direction.x() * direction.x() * m.xx +
                        2.0 * direction.x() * direction.y() * m.xy +
                        direction.y() * direction.y() * m.yy;
  // Where their weighted mean is, offset and angle are independent.
  const double offset_variance = excess / (information * m.w);
  const double angle_variance = excess / (information * (second - mean * mean * m.w));
  const double lever = along - mean;
  Eigen::Matrix2d covariance;
  covariance << offset_variance + lever * lever * angle_variance, lever * angle_variance,
      lever * angle_variance, angle_variance;
  return covariance;
}

/// Where the beam meets the wall's line. The wall goes on behind its last beam by up to the
/// distance of beams on it.
WallEnd end_at(std::size_t i, const PolarLine& polar, const Wall& wall, const Beams& beams) {
  const Vector2 ray = beams.end(i);
  const double beam_distance = distance_between_beams(beams, i, wall.line.normal);
  const double along = beam_distance * beam_distance / 3.0;
  WallEnd end;
  end.location = beams.laser + ray / (polar.a * ray.x() + polar.b * ray.y());
  end.covariance =
      along * wall.line.direction * wall.line.direction.transpose() +
      variance_across(wall, end.location) * wall.line.normal * wall.line.normal.transpose();
  return end;
}

}  // namespace

double variance_across(const Wall& wall, const Vector2& place) {
  const double along = wall.line.direction.dot(place - wall.line.point);
  return wall.line_covariance(0, 0) + 2.0 * along * wall.line_covariance(0, 1) +
         along * along * wall.line_covariance(1, 1);
}

Verdict fit_wall(const Run& run, const Sweep& sweep, const ScanParameters& parameters, Wall& wall) {
  const Beams& beams = sweep.beams;
  PolarLine line = polar_line(run.moments);
  double excess = excess_of(run.moments, parameters);
  Support support;
  support.count = static_cast<int>(run.moments.beams);
  for (int fit = 0; fit < kFits; ++fit) {
    const int before = support.count;
    support = find_support(run, sweep, line, excess, parameters);
    const auto between = static_cast<double>(support.last + 1 - support.first);
    if (support.count < parameters.wall.min_beams) return Verdict::too_few_beams;
    if (support.count < parameters.wall.min_support_share * between) return Verdict::too_scattered;
    if (support.count == before) break;
    line = unbiased_line(support);
    excess = excess_of(support.moments, parameters);
  }

  line = unbiased_line(support);
  wall.line = make_line(line, beams.laser);
  const Vector2 direction = wall.line.direction;
  const auto along = [&](std::size_t i) { return direction.dot(beams.end(i)); };
  const double middle = 0.5 * (along(support.first) + along(support.last));
  const Misfit fit = misfit(support.moments, parameters.noise.surface_roughness);
  wall.line.point += middle * direction;
  wall.line_covariance = covariance_at(middle, direction, support.moments, fit, excess);
  wall.first_beam = support.first;
  wall.last_beam = support.last;
  wall.support = support.count;
  if (!(std::sqrt(wall.line_covariance(1, 1)) <= parameters.wall.max_angle_sigma))
    return Verdict::too_uncertain;

  wall.first = end_at(support.first, line, wall, beams);
  wall.last = end_at(support.last, line, wall, beams);
  if (distance(wall.first.location, wall.last.location) < parameters.wall.min_length)
    return Verdict::too_short;
  return Verdict::wall;
}

}  // namespace perceptor::scan
