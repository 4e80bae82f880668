#include "tools/eval/localize/outcome.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include "common/geometry/angle.hpp"

namespace perceptor {
namespace {

Eigen::Vector3d error_of(const Fix& fix) {
  const Position& pose = fix.robot_in_world.pose;
  return {fix.truth.x - pose.x, fix.truth.y - pose.y, angle_difference(pose.a, fix.truth.a)};
}

bool is_right(const Fix& fix, const OutcomeParameters& parameters) {
  const Eigen::Vector3d error = error_of(fix);
  return fix.is_tracking && error.head<2>().norm() < parameters.distance &&
         std::abs(error[2]) < parameters.angle;
}

std::optional<double> found(const std::vector<Fix>& fixes, const OutcomeParameters& parameters) {
  std::optional<double> since;
  for (const Fix& fix : fixes) {
    if (!is_right(fix, parameters))
      since.reset();
    else if (!since)
      since = fix.time;
    if (since && fix.time - *since >= parameters.held) return since;
  }
  return std::nullopt;
}

double longest_false(const std::vector<Fix>& fixes, const OutcomeParameters& parameters) {
  std::optional<double> since;
  double longest = 0.0;
  for (const Fix& fix : fixes) {
    if (!fix.is_tracking || is_right(fix, parameters))
      since.reset();
    else if (!since)
      since = fix.time;
    if (since) longest = std::max(longest, fix.time - *since);
  }
  return longest;
}

TrackingError tracking_error(const std::vector<Fix>& fixes, double since,
                             const OutcomeParameters& parameters) {
  TrackingError error;
  for (const Fix& fix : fixes) {
    if (fix.time < since + parameters.settled || !fix.is_tracking) continue;
    const Eigen::Vector3d off = error_of(fix);
    error.squared_distance += off.head<2>().squaredNorm();
    error.squared_angle += off[2] * off[2];
    error.nees += off.dot(fix.robot_in_world.covariance.inverse() * off);
    ++error.fixes;
  }
  return error;
}

}  // namespace

TrackingError& TrackingError::operator+=(const TrackingError& other) {
  squared_distance += other.squared_distance;
  squared_angle += other.squared_angle;
  nees += other.nees;
  fixes += other.fixes;
  return *this;
}

Outcome judge(const Drive& drive, const OutcomeParameters& parameters) {
  Outcome outcome;
  outcome.combined = drive.combined;
  outcome.found = found(drive.fixes, parameters);
  outcome.longest_false = longest_false(drive.fixes, parameters);
  outcome.said_ambiguous =
      std::ranges::any_of(drive.fixes, [](const Fix& fix) { return fix.is_ambiguous; });
  if (outcome.found) outcome.error = tracking_error(drive.fixes, *outcome.found, parameters);
  outcome.was_tracking =
      !drive.after.empty() && !drive.fixes.empty() && is_right(drive.fixes.back(), parameters);
  if (!outcome.was_tracking) return outcome;
  const auto noticed = std::ranges::find_if(
      drive.after, [&](const Fix& fix) { return !fix.is_tracking || is_right(fix, parameters); });
  if (noticed != drive.after.end()) outcome.noticed = noticed->time;
  outcome.found_again = found(drive.after, parameters);
  return outcome;
}

}  // namespace perceptor
