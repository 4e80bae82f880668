#include "components/merge/registration.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "common/geometry/angle.hpp"
#include "components/merge/association.hpp"
#include "components/merge/normal_equations.hpp"
#include "components/merge/sighting.hpp"

namespace perceptor::merge {
namespace {

double square(double value) { return value * value; }

NormalEquations normal_equations(const Position& robot_in_local, const std::vector<Wall>& sighted,
                                 const std::vector<Wall>& known,
                                 const std::vector<Line>& known_lines,
                                 const std::vector<Match>& matches, double outlier_sigmas,
                                 const RegistrationParameters& parameters) {
  const bool with_lines = parameters.landmarks != Landmarks::corners;
  const bool with_corners = parameters.landmarks != Landmarks::walls;
  NormalEquations equations;
  for (const Match& match : matches) {
    const Wall& wall = sighted[match.sighted];
    const Wall& known_wall = known[match.known];
    const Line& line = known_lines[match.known];
    if (with_lines) add_line(equations, robot_in_local, wall, known_wall, line, outlier_sigmas);
    if (with_corners && known_wall.confirmed)  // what walks by has ends as well
      add_corners(equations, robot_in_local, wall, known_wall, line, with_lines,
                  parameters.same_wall.shift, outlier_sigmas);
  }
  return equations;
}

/// The direction in which the walls alone would leave the position loose. The worst one, as a
/// unit vector, where that is so.
std::optional<Vector2> loose_direction(const NormalEquations& equations, double sigma) {
  const Eigen::Matrix3d& information = equations.information;
  const double heading = information(2, 2);
  if (heading <= 0.0) return std::nullopt;
  // The heading is unknown too: what is left for translation is its Schur complement.
  const Eigen::Vector2d mixed = information.topRightCorner<2, 1>();
  const Eigen::Matrix2d translation =
      information.topLeftCorner<2, 2>() - mixed * mixed.transpose() / heading;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(translation);
  const double weakest = axes.eigenvalues()[0] - equations.spurious;
  if (weakest >= 1.0 / square(sigma)) return std::nullopt;
  return axes.eigenvectors().col(0);
}

/// Takes out what the equations say along `direction`.
void silence(NormalEquations& equations, const Vector2& direction) {
  Eigen::Matrix3d keep = Eigen::Matrix3d::Identity();
  keep.topLeftCorner<2, 2>() -= direction * direction.transpose();
  equations.information = keep * equations.information * keep;
  equations.gradient = keep * equations.gradient;
}

Eigen::Vector3d difference(const Position& from, const Position& to) {
  return {to.x - from.x, to.y - from.y, angle_difference(from.a, to.a)};
}

Position moved(const Position& pose, const Eigen::Vector3d& change) {
  return {pose.x + change[0], pose.y + change[1], wrap_angle(pose.a + change[2])};
}

struct Correction {
  PoseEstimate robot_in_local;
  std::optional<Vector2> loose;
};

/// Least squares with the matches held: prediction and walls together, from `start`.
Correction correct(const PoseEstimate& predicted, const Position& start,
                   const std::vector<Wall>& sighted, const std::vector<Wall>& known,
                   const std::vector<Line>& known_lines, const std::vector<Match>& matches,
                   double outlier_sigmas, const RegistrationParameters& parameters) {
  const Eigen::Matrix3d prior = predicted.covariance.inverse();
  Correction correction{{start, predicted.covariance}, std::nullopt};
  Position& pose = correction.robot_in_local.pose;
  constexpr double kConverged = 1e-10;
  for (int i = 0; i < parameters.iterations; ++i) {
    NormalEquations equations =
        normal_equations(pose, sighted, known, known_lines, matches, outlier_sigmas, parameters);
    correction.loose = loose_direction(equations, parameters.unobservable_sigma);
    if (correction.loose) silence(equations, *correction.loose);
    const Eigen::Matrix3d information = prior + equations.information;
    const Eigen::Vector3d gradient = equations.gradient + prior * difference(pose, predicted.pose);
    const Eigen::LDLT<Eigen::Matrix3d> solver(information);
    const Eigen::Vector3d change = solver.solve(gradient);
    correction.robot_in_local.covariance = solver.solve(Eigen::Matrix3d::Identity());
    pose = moved(pose, change);
    if (change.norm() < kConverged) break;
  }
  return correction;
}

bool is_plausible(const Position& predicted, const Position& corrected,
                  const RegistrationParameters& parameters) {
  const Eigen::Vector3d change = difference(predicted, corrected);
  return change.head<2>().norm() <= parameters.max_correction &&
         std::abs(change[2]) <= parameters.max_heading_correction;
}

/// Whether the matched walls lie on each other after the correction, by length.
bool agrees(const PoseEstimate& robot_in_local, const std::vector<Wall>& sighted,
            const std::vector<Wall>& known, const std::vector<Line>& known_lines,
            const std::vector<Match>& matches, const SameWallParameters& agreement,
            double min_agreement) {
  double matched = 0.0;
  double agreed = 0.0;
  for (const Match& match : matches) {
    const Wall wall =
        transform(robot_in_local.pose, robot_in_local.covariance, sighted[match.sighted]);
    const Line line = line_of(wall.segment);
    matched += line.length;
    if (compare(wall, line, known[match.known], known_lines[match.known], agreement))
      agreed += line.length;
  }
  return agreed >= min_agreement * matched;
}

}  // namespace

Registration register_walls(const std::vector<Wall>& sighted, const std::vector<Wall>& known,
                            const std::vector<Line>& known_lines, const PoseEstimate& predicted,
                            const Vector2& laser_in_robot, const SameWallParameters& agreement,
                            const RegistrationParameters& parameters) {
  Registration unregistered;
  unregistered.robot_in_local = predicted;
  unregistered.unobservable = Vector2(std::cos(predicted.pose.a), std::sin(predicted.pose.a));

  Correction correction{predicted, std::nullopt};
  std::vector<Match> matches;
  // All walls that agree on a slip look like outliers at first: doubt comes by and by.
  double outlier_sigmas =
      parameters.outlier_sigmas * std::pow(parameters.annealing, parameters.rounds - 1);
  for (int round = 0; round < parameters.rounds; ++round) {
    // The gate follows what is still uncertain: the prediction first, then the correction.
    std::vector<Wall> in_local;
    in_local.reserve(sighted.size());
    for (const Wall& wall : sighted)
      in_local.push_back(
          transform(correction.robot_in_local.pose, correction.robot_in_local.covariance, wall));
    const Vector2 laser = transform(correction.robot_in_local.pose, laser_in_robot);
    matches = match_walls(in_local, known, known_lines, laser, parameters.same_wall);
    if (matches.empty()) return unregistered;
    correction = correct(predicted, correction.robot_in_local.pose, sighted, known, known_lines,
                         matches, outlier_sigmas, parameters);
    outlier_sigmas /= parameters.annealing;
  }

  const PoseEstimate& corrected = correction.robot_in_local;
  const bool is_believed =
      is_plausible(predicted.pose, corrected.pose, parameters) &&
      agrees(corrected, sighted, known, known_lines, matches, agreement, parameters.min_agreement);
  if (!is_believed) {
    unregistered.rejected = true;
    return unregistered;
  }
  Registration registration;
  registration.robot_in_local = corrected;
  registration.matched = static_cast<int>(matches.size());
  registration.unobservable = correction.loose;
  return registration;
}

}  // namespace perceptor::merge
