#include "components/merge/normal_equations.hpp"

#include <Eigen/LU>

namespace perceptor::merge {
namespace {

double square(double value) { return value * value; }

/// Weight of a residual of so many sigmas (Zhang, see registration.hpp).
double cauchy_weight(double sigmas_squared, double outlier_sigmas) {
  return 1.0 / (1.0 + sigmas_squared / square(outlier_sigmas));
}

}  // namespace

void add_line(NormalEquations& equations, const Position& robot_in_local, const Wall& sighted,
              const Wall& known, const Line& known_line, double outlier_sigmas) {
  const Line line = line_of(transform(robot_in_local, sighted.segment));
  const Vector2 from_known = line.middle - known_line.middle;
  const Vector2 lever = perpendicular(line.middle - robot_in_local.location());
  const Eigen::Vector2d residual(known_line.normal.dot(from_known), turn_between(known_line, line));
  Eigen::Matrix<double, 2, 3> by_pose;
  by_pose << known_line.normal.x(), known_line.normal.y(), known_line.normal.dot(lever), 0.0, 0.0,
      1.0;
  const double reach = known_line.along.dot(from_known);
  const Eigen::Matrix2d covariance = sighted.covariance + moved_along(known.covariance, reach);
  const Eigen::Matrix2d inverse_covariance = covariance.inverse();
  const double trust = cauchy_weight(residual.dot(inverse_covariance * residual), outlier_sigmas);

  const Eigen::Matrix<double, 3, 2> weighted = by_pose.transpose() * inverse_covariance * trust;
  equations.information += weighted * by_pose;
  equations.gradient -= weighted * residual;
  equations.spurious += trust * inverse_covariance(0, 0) * covariance(1, 1);
}

void add_corners(NormalEquations& equations, const Position& robot_in_local, const Wall& sighted,
                 const Wall& known, const Line& known_line, bool along_only, double max_shift,
                 double outlier_sigmas) {
  const Segment segment = transform(robot_in_local, sighted.segment);
  const Line line = line_of(segment);
  for (const std::size_t end : {kTail, kHead}) {
    const bool are_corners =
        along_only ? is_seen_as_end(sighted.ends[end]) && is_seen_as_end(known.ends[end])
                   : is_known(sighted.ends[end]) && is_known(known.ends[end]);
    if (!are_corners) continue;
    const Vector2 place = end == kHead ? segment.b : segment.a;
    const Vector2 residual = place - (end == kHead ? known.segment.b : known.segment.a);
    if (residual.squaredNorm() > square(max_shift)) continue;
    const Eigen::Matrix2d covariance =
        end_covariance(sighted, line, end) + end_covariance(known, known_line, end);
    Eigen::Matrix2d information = covariance.inverse();
    if (along_only)
      information = known_line.along * known_line.along.transpose() /
                    known_line.along.dot(covariance * known_line.along);
    Eigen::Matrix<double, 2, 3> by_pose;
    by_pose << Eigen::Matrix2d::Identity(), perpendicular(place - robot_in_local.location());
    const double trust = cauchy_weight(residual.dot(information * residual), outlier_sigmas);
    const Eigen::Matrix<double, 3, 2> weighted = by_pose.transpose() * information * trust;
    equations.information += weighted * by_pose;
    equations.gradient -= weighted * residual;
  }
}

}  // namespace perceptor::merge
