#include "components/localize/beam_alignment.hpp"

#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "common/geometry/angle.hpp"

namespace perceptor::localize {
namespace {

double square(double value) { return value * value; }

/// [m] An end lies so far past the end of its face at most: it is not drawn along it.
constexpr double kPast = 0.05;

}  // namespace

PoseEstimate align_beams(const World& world, const std::vector<Beam>& beams,
                         const PoseEstimate& start, const BeamAlignmentParameters& parameters) {
  const Eigen::Matrix3d prior = start.covariance.inverse();
  const double information_of_one = 1.0 / (square(parameters.map_sigma) * parameters.together);
  PoseEstimate aligned = start;
  Position& pose = aligned.pose;
  for (int i = 0; i < parameters.iterations; ++i) {
    const Eigen::Vector3d moved(start.pose.x - pose.x, start.pose.y - pose.y,
                                angle_difference(pose.a, start.pose.a));
    Eigen::Matrix3d information = prior;
    Eigen::Vector3d gradient = prior * moved;
    for (const Beam& beam : beams) {
      const Vector2 end = transform(pose, beam.origin + beam.range * beam.direction);
      const Vector2 back = unit(transform(pose, beam.origin) - end);
      const Face* face = world.nearest_face(end, back, parameters.reach, parameters.min_cosine);
      if (face == nullptr) continue;
      const double offset = face->line.normal.dot(end - face->line.middle);
      if (distance(face->segment, end) > std::abs(offset) + kPast) continue;
      const Vector2 lever = perpendicular(end - pose.location());
      const Eigen::Vector3d jacobian(face->line.normal.x(), face->line.normal.y(),
                                     face->line.normal.dot(lever));
      const double weight = information_of_one / (1.0 + square(offset / parameters.outlier));
      information += weight * jacobian * jacobian.transpose();
      gradient -= weight * offset * jacobian;
    }
    const Eigen::Vector3d change = information.ldlt().solve(gradient);
    pose = {pose.x + change[0], pose.y + change[1], wrap_angle(pose.a + change[2])};
    aligned.covariance = information.inverse();
  }
  return aligned;
}

}  // namespace perceptor::localize
