#include "components/scan/walls.hpp"

#include <algorithm>
#include <cmath>

#include "components/scan/support.hpp"

namespace perceptor::scan {
namespace {

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

/// Where the beam meets the wall's line, but no further from where it ended than its noise
/// explains: on a grazed wall a small step aside is a long way along the beam. The wall goes on
/// behind its last beam by up to the distance of beams on it.
WallEnd end_at(std::size_t i, const Wall& wall, const Beams& beams,
               const ScanParameters& parameters) {
  const Vector2 along = beams.end(i) / beams.range[i];
  const double meets_at = offset(wall.line, beams.laser) / std::abs(along.dot(wall.line.normal));
  const double noise = parameters.wall.support_sigmas * beams.sigma(i);
  const double ends_at = std::clamp(meets_at, beams.range[i] - noise, beams.range[i] + noise);
  const Vector2 place = beams.laser + ends_at * along;

  const double beam_distance = distance_between_beams(beams, i, wall.line.normal);
  WallEnd end;
  end.location = place - offset(wall.line, place) * wall.line.normal;
  end.covariance =
      beam_distance * beam_distance / 3.0 * wall.line.direction * wall.line.direction.transpose() +
      variance_across(wall, end.location) * wall.line.normal * wall.line.normal.transpose();
  return end;
}

}  // namespace

double variance_across(const Wall& wall, const Vector2& place) {
  const double along = wall.line.direction.dot(place - wall.line.point);
  return wall.line_covariance(0, 0) + 2.0 * along * wall.line_covariance(0, 1) +
         along * along * wall.line_covariance(1, 1);
}

double angle_sigma(const Wall& wall) { return std::sqrt(wall.line_covariance(1, 1)); }

double length(const Wall& wall) { return distance(wall.first.location, wall.last.location); }

double support_share(const Wall& wall) {
  return wall.support / static_cast<double>(wall.last_beam + 1 - wall.first_beam);
}

bool supports(const Beams& beams, std::size_t i, const Wall& wall,
              const ScanParameters& parameters) {
  const double off = offset(wall.line, beams.location(i));
  const double distance = offset(wall.line, beams.laser);
  const double sigmas = parameters.wall.support_sigmas;
  return off * off <=
         sigmas * sigmas * wall.excess * variance_across(beams, i, distance, parameters.noise);
}

Verdict fit_wall(const Run& run, const Sweep& sweep, const ScanParameters& parameters, Wall& wall) {
  const Beams& beams = sweep.beams;
  const auto [line, support, excess] = fit_supported_line(run, sweep, parameters);
  wall.first_beam = support.first;
  wall.last_beam = support.last;
  wall.support = support.count;
  wall.excess = excess;
  if (support.count < parameters.wall.min_beams) return Verdict::too_few_beams;
  if (support_share(wall) < parameters.wall.min_support_share) return Verdict::too_scattered;

  wall.line = make_line(line, beams.laser);
  const Vector2 direction = wall.line.direction;
  const auto along = [&](std::size_t i) { return direction.dot(beams.end(i)); };
  const double middle = 0.5 * (along(support.first) + along(support.last));
  wall.line.point += middle * direction;
  const Misfit fit = misfit(support.moments, parameters.noise.surface_roughness);
  wall.line_covariance = covariance_at(middle, direction, support.moments, fit, excess);
  wall.first = end_at(support.first, wall, beams, parameters);
  wall.last = end_at(support.last, wall, beams, parameters);
  if (!(angle_sigma(wall) <= parameters.wall.max_angle_sigma)) return Verdict::too_uncertain;
  if (length(wall) < parameters.wall.min_length) return Verdict::too_short;
  return Verdict::wall;
}

}  // namespace perceptor::scan
