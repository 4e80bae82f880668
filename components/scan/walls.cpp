#include "components/scan/walls.hpp"

#include <algorithm>
#include <cmath>

namespace perceptor::scan {
namespace {

/// Fits after which the set of supporting beams has settled, or never will.
constexpr int kFits = 3;

/// The beams that support a line, and what they say about a better one.
struct Support {
  std::size_t first = 0;
  std::size_t last = 0;
  int count = 0;
  double chi_square = 0.0;              ///< of their distances from the line
  double w = 0.0;                       ///< [1/m^2] sum of inverse variances across the line
  Vector2 mean{0.0, 0.0};               ///< [m] weighted, from the line's point
  double xx = 0.0, xy = 0.0, yy = 0.0;  ///< [-] weighted, about the mean
};

/// The beams of the run within some sigmas of the line. `excess` is their variance over what
/// the noise says.
Support find_support(const Run& run, const Beams& beams, const Line& line, double excess,
                     const ScanParameters& parameters) {
  const double sigmas = parameters.wall.support_sigmas;
  const double limit = sigmas * sigmas * excess;
  Support support;
  Vector2 weighted = Vector2::Zero();
  for (std::size_t i = run.begin; i < run.end; ++i) {
    const double w = 1.0 / variance_across(beams[i], line.normal, parameters.noise);
    const double off = offset(line, beams[i].location);
    if (off * off * w > limit) continue;
    if (support.count++ == 0) support.first = i;
    support.last = i;
    support.chi_square += off * off * w;
    const Vector2 place = beams[i].location - line.point;
    support.w += w;
    weighted += w * place;
    support.xx += w * place.x() * place.x();
    support.xy += w * place.x() * place.y();
    support.yy += w * place.y() * place.y();
  }
  if (support.count == 0) return support;
  support.mean = weighted / support.w;
  support.xx -= weighted.x() * support.mean.x();
  support.xy -= weighted.x() * support.mean.y();
  support.yy -= weighted.y() * support.mean.y();
  return support;
}

/// The best line through the supporting beams of the line before.
Line line_of(const Support& support, const Line& before, const Vector2& laser) {
  const double angle = 0.5 * std::atan2(2.0 * support.xy, support.xx - support.yy);
  return make_line(before.point + support.mean, Vector2(std::cos(angle), std::sin(angle)), laser);
}

/// By how much the beams scatter more than the noise says: not straight, or not so precise.
double excess_of(double chi_square, double beams, const ScanParameters& parameters) {
  const double degrees_of_freedom = std::max(1.0, beams - 2.0);
  return std::clamp(chi_square / degrees_of_freedom, 1.0, parameters.wall.max_excess);
}

/// Inverse of the information that the beams hold about offset and angle at a place that is
/// `along` [m] from their weighted mean: there, the two are independent.
Eigen::Matrix2d covariance_at(double along, const Support& support, double excess) {
  const double offset_variance = excess / support.w;
  const double angle_variance = excess / (support.xx + support.yy);
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

std::optional<Wall> fit_wall(const Run& run, const Beams& beams, const ScanParameters& parameters) {
  const auto is_enough = [&parameters](const Support& support) {
    const auto between = static_cast<double>(support.last - support.first + 1);
    return support.count >= parameters.wall.min_beams &&
           support.count >= parameters.wall.min_support_share * between;
  };
  Line line = fit_line(run.moments, beams.laser);
  double excess =
      excess_of(misfit(run.moments, parameters.noise).chi_square, run.moments.beams, parameters);
  Support support;
  for (int fit = 0; fit < kFits; ++fit) {
    support = find_support(run, beams, line, excess, parameters);
    if (!is_enough(support)) return std::nullopt;
    line = line_of(support, line, beams.laser);
    excess = excess_of(support.chi_square, support.count, parameters);
  }

  const double from = line.direction.dot(beams[support.first].location - line.point);
  const double to = line.direction.dot(beams[support.last].location - line.point);
  const double middle = 0.5 * (from + to);
  Wall wall;
  wall.line = line;
  wall.line.point += middle * line.direction;
  wall.line_covariance = covariance_at(middle, support, excess);
  wall.first_beam = support.first;
  wall.last_beam = support.last;
  wall.support = support.count;
  const bool is_certain = std::sqrt(wall.line_covariance(1, 1)) <= parameters.wall.max_angle_sigma;
  if (!is_certain || to - from < parameters.wall.min_length) return std::nullopt;

  wall.first = end_at(beams[support.first], wall, beams);
  wall.last = end_at(beams[support.last], wall, beams);
  return wall;
}

}  // namespace perceptor::scan
