#include "components/localize/alignment.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "common/geometry/angle.hpp"

namespace perceptor::localize {
namespace {

double square(double value) { return value * value; }

/// The nearest face that looks the same way and lies beside the wall.
const Face* face_of(const World& world, const Line& wall, const AlignmentParameters& parameters) {
  const Face* nearest = nullptr;
  double least = parameters.max_offset;
  const double min_cosine = std::cos(parameters.max_angle);
  for (const Face& face : world.faces()) {
    if (face.line.along.dot(wall.along) < min_cosine) continue;
    const double offset = std::abs(face.line.normal.dot(wall.middle - face.line.middle));
    if (offset >= least) continue;
    const Interval common = common_part(extent_of(face.line), extent_on(face.line, wall));
    const double shorter = std::min(wall.length, face.line.length);
    if (common.length() < parameters.min_overlap * shorter) continue;
    nearest = &face;
    least = offset;
  }
  return nearest;
}

/// [m] A wall this far from its face is another thing: it says nothing of the map's error.
constexpr double kOffTheMap = 0.1;

struct NormalEquations {
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d of_map = Eigen::Matrix3d::Zero();  ///< information if only the map erred
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
  double squared_offsets = 0.0;   ///< [m^2] sum, from walls to faces
  double offset_variances = 0.0;  ///< [m^2] what of it the walls' own errors explain
  int offsets = 0;                ///< how many

  /// One measurement: `residual` changes by `jacobian` with the pose.
  void add(const Eigen::Vector3d& jacobian, double residual, double variance, double map_variance,
           double outlier_sigmas) {
    const double total = variance + map_variance;
    const double weight = 1.0 / (1.0 + square(residual / outlier_sigmas) / total);
    information += weight / total * jacobian * jacobian.transpose();
    of_map += weight / map_variance * jacobian * jacobian.transpose();
    gradient -= weight / total * jacobian * residual;
  }
};

void add_wall(NormalEquations& equations, const Position& frame_in_world, const LocalWall& wall,
              const Face& face, const AlignmentParameters& parameters) {
  const Line& line = face.line;
  const double map_variance = square(parameters.map_sigma);
  const auto jacobian = [&](const Vector2& axis, const Vector2& point) {
    const Vector2 lever = perpendicular(point - frame_in_world.location());
    return Eigen::Vector3d(axis.x(), axis.y(), axis.dot(lever));
  };
  const double offset = line.normal.dot(wall.line.middle - line.middle);
  equations.add(jacobian(line.normal, wall.line.middle), offset, wall.covariance(0, 0),
                map_variance, parameters.outlier_sigmas);
  // A face whose ends are off by the map's error turns by so much.
  equations.add({0.0, 0.0, 1.0}, turn_between(line, wall.line), wall.covariance(1, 1),
                2.0 * map_variance / square(line.length), parameters.outlier_sigmas);
  const std::array<Vector2, 2> ends = {wall.segment.a, wall.segment.b};
  const std::array<Vector2, 2> corners = {face.segment.a, face.segment.b};
  for (const std::size_t i : {0U, 1U}) {
    const double shift = line.along.dot(ends[i] - corners[i]);
    if (!wall.is_corner[i] || std::abs(shift) > parameters.max_shift) continue;
    equations.add(jacobian(line.along, ends[i]), shift, wall.end_variance[i], map_variance,
                  parameters.outlier_sigmas);
  }
  if (std::abs(offset) > kOffTheMap) return;
  equations.squared_offsets += square(offset);
  equations.offset_variances += wall.covariance(0, 0);
  ++equations.offsets;
}

Eigen::Vector3d difference(const Position& from, const Position& to) {
  return {to.x - from.x, to.y - from.y, angle_difference(from.a, to.a)};
}

/// Least information along any axis: 1 m, for a pose that is fixed at all.
constexpr double kLoose = 1.0;

}  // namespace

std::optional<Alignment> align(const World& world, const std::vector<LocalWall>& walls,
                               const PoseEstimate& start, bool prior,
                               const AlignmentParameters& parameters) {
  const Eigen::Matrix3d prior_information =
      prior ? Eigen::Matrix3d(start.covariance.inverse()) : Eigen::Matrix3d::Zero();
  Alignment alignment;
  Position& pose = alignment.frame_in_world.pose;
  pose = start.pose;
  NormalEquations equations;
  for (int i = 0; i < parameters.iterations; ++i) {
    equations = {};
    alignment.matched = 0;
    alignment.matched_length = 0.0;
    for (const LocalWall& wall : walls) {
      const LocalWall moved = transform(pose, wall);
      const Face* face = face_of(world, moved.line, parameters);
      if (face == nullptr) continue;
      ++alignment.matched;
      alignment.matched_length +=
          common_part(extent_of(face->line), extent_on(face->line, moved.line)).length();
      add_wall(equations, pose, moved, *face, parameters);
    }
    const Eigen::Matrix3d information = prior_information + equations.information;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(information, Eigen::EigenvaluesOnly);
    if (axes.eigenvalues()[0] < kLoose) return std::nullopt;
    const Eigen::LDLT<Eigen::Matrix3d> solver(information);
    const Eigen::Vector3d change =
        solver.solve(equations.gradient + prior_information * difference(pose, start.pose));
    pose = {pose.x + change[0], pose.y + change[1], wrap_angle(pose.a + change[2])};
    alignment.frame_in_world.covariance = solver.solve(Eigen::Matrix3d::Identity());
  }
  // The pose took three of the offsets for itself.
  constexpr int kTaken = 3;
  if (const int left = equations.offsets - kTaken; left > 0)
    alignment.map_variance =
        std::max(0.0, (equations.squared_offsets - equations.offset_variances) / left);
  // Where the walls say nothing the map's error does not matter.
  alignment.map_covariance = (equations.of_map + kLoose * Eigen::Matrix3d::Identity()).inverse();
  return alignment;
}

}  // namespace perceptor::localize
