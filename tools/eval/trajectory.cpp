#include "tools/eval/trajectory.hpp"

#include <algorithm>

#include "common/time/stamp.hpp"

namespace perceptor {

std::optional<Position> pose_at(const Trajectory& trajectory, std::int64_t utime, double max_gap) {
  const auto after = std::ranges::lower_bound(trajectory, utime, {}, &TimedPose::utime);
  if (after == trajectory.end()) return std::nullopt;
  if (after->utime == utime) return after->pose;
  if (after == trajectory.begin()) return std::nullopt;
  const TimedPose& before = *(after - 1);
  const double width = seconds_between(before.utime, after->utime);
  if (width > max_gap) return std::nullopt;
  return interpolate(before.pose, after->pose, seconds_between(before.utime, utime) / width);
}

void put_in_order(Trajectory& trajectory) {
  std::ranges::stable_sort(trajectory, {}, &TimedPose::utime);
  const auto repeated = std::ranges::unique(trajectory, {}, &TimedPose::utime);
  trajectory.erase(repeated.begin(), repeated.end());
}

std::vector<double> driven(const Trajectory& trajectory) {
  std::vector<double> lengths;
  lengths.reserve(trajectory.size());
  double length = 0.0;
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    if (i > 0) length += distance(trajectory[i - 1].pose.location(), trajectory[i].pose.location());
    lengths.push_back(length);
  }
  return lengths;
}

}  // namespace perceptor
