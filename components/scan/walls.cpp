#include "components/scan/walls.hpp"

#include <algorithm>
#include <cmath>

namespace perceptor {
namespace {

/// Fits after which the set of supporting beams has settled, or never will.
constexpr int kFits = 4;

/// The supporting beams of a line, and what they say about it.
struct Support {
  std::size_t first = 0;
  std::size_t last = 0;
  int count = 0;
};

bool supports(const Beam& beam, const Line& line, const ScanParameters& parameters) {
  const double off = offset(line, beam.location);
  const double sigmas = parameters.wall.support_sigmas;
  return off * off <= sigmas * sigmas * variance_across(beam, line.normal, parameters.noise);
}

Support find_support(const Run& run, const Beams& beams, const Line& line,
                     const ScanParameters& parameters) {
  Support support;
  for (std::size_t i = run.begin; i < run.end; ++i) {
    if (!supports(beams[i], line, parameters)) continue;
    if (support.count++ == 0) support.first = i;
    support.last = i;
  }
  return support;
}

/// Sums over the supporting beams, each weighted by its own error across the line; places
/// are told from the line's point.
struct Sums {
  double w = 0.0;                             ///< [1/m^2]
  Vector2 mean{0.0, 0.0};                     ///< [m] from the line's point
  double xx = 0.0, xy = 0.0, yy = 0.0;        ///< about the mean [-]
};

Sums sum_support(const Support& support, const Beams& beams, const Line& line,
                 const ScanParameters& parameters) {
  Sums sums;
  Vector2 weighted = Vector2::Zero();
  for (std::size_t i = support.first; i <= support.last; ++i) {
    if (!supports(beams[i], line, parameters)) continue;
    const double w = 1.0 / variance_across(beams[i], line.normal, parameters.noise);
    const Vector2 place = beams[i].location - line.point;
    sums.w += w;
    weighted += w * place;
    sums.xx += w * place.x() * place.x();
    sums.xy += w * place.x() * place.y();
    sums.yy += w * place.y() * place.y();
  }
  sums.mean = weighted / sums.w;
  sums.xx -= weighted.x() * sums.mean.x();
  sums.xy -= weighted.x() * sums.mean.y();
  sums.yy -= weighted.y() * sums.mean.y();
  return sums;
}

Line line_of(const Sums& sums, const Line& before, const Vector2& laser) {
  const double angle = 0.5 * std::atan2(2.0 * sums.xy, sums.xx - sums.yy);
  return make_line(before.point + sums.mean, Vector2(std::cos(angle), std::sin(angle)), laser);
}

/// Inverse of the information that the beams hold about offset and angle at a place that is
/// `along` [m] from their weighted mean: there, the two are independent.
Eigen::Matrix2d covariance_at(double along, const Sums& sums) {
  const double offset_variance = 1.0 / sums.w;
  const double angle_variance = 1.0 / (sums.xx + sums.yy);
  Eigen::Matrix2d covariance;
  covariance << offset_variance + along * along * angle_variance, along * angle_variance,
      along * angle_variance, angle_variance;
  return covariance;
}

/// A wall goes on behind its last beam by up to the distance of beams on it.
WallEnd end_at(const Beam& beam, const Wall& wall, const Beams& beams) {
  const Line& line = wall.line;
  const double beam_distance = distance_between_beams(beams, beam, line.normal);
  const double along_noise = beam.sigma * beam.along.dot(line.direction);
  const double along = beam_distance * beam_distance / 3.0 + along_noise * along_noise;

  WallEnd end;
  end.location = beam.location - offset(line, beam.location) * line.normal;
  end.covariance = along * line.direction * line.direction.transpose() +
                   variance_across(wall, end.location) * line.normal * line.normal.transpose();
  return end;
}

}  // namespace

double variance_across(const Wall& wall, const Vector2& place) {
  const double along = wall.line.direction.dot(place - wall.line.point);
  return wall.line_covariance(0, 0) + 2.0 * along * wall.line_covariance(0, 1) +
         along * along * wall.line_covariance(1, 1);
}

std::optional<Wall> fit_wall(const Run& run, const Beams& beams,
                             const ScanParameters& parameters) {
  const auto is_enough = [&parameters](const Support& support) {
    const auto between = static_cast<double>(support.last - support.first + 1);
    return support.count >= parameters.wall.min_beams &&
           support.count >= parameters.wall.min_support_share * between;
  };
  Line line = fit_line(run.moments, beams.laser);
  Support support;
  Sums sums;
  for (int fit = 0; fit < kFits; ++fit) {
    const Support before = support;
    support = find_support(run, beams, line, parameters);
    if (!is_enough(support)) return std::nullopt;
    sums = sum_support(support, beams, line, parameters);
    line = line_of(sums, line, beams.laser);
    const bool is_settled = support.count == before.count && support.first == before.first;
    if (is_settled) break;
  }

  const double from = line.direction.dot(beams[support.first].location - line.point);
  const double to = line.direction.dot(beams[support.last].location - line.point);
  const double middle = 0.5 * (from + to);
  Wall wall;
  wall.line = line;
  wall.line.point += middle * line.direction;
  wall.line_covariance = covariance_at(middle, sums);
  wall.first_beam = support.first;
  wall.last_beam = support.last;
  wall.support = support.count;
  const bool is_certain = std::sqrt(wall.line_covariance(1, 1)) <= parameters.wall.max_angle_sigma;
  if (!is_certain || to - from < parameters.wall.min_length) return std::nullopt;

  wall.first = end_at(beams[support.first], wall, beams);
  wall.last = end_at(beams[support.last], wall, beams);
  return wall;
}

}  // namespace perceptor
