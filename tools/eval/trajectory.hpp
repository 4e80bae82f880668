/// @file Where the robot was, over time.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "common/geometry/position.hpp"

namespace perceptor {

struct TimedPose {
  std::int64_t utime = 0;  ///< [us]
  Position pose;
};

/// In order of time, no utime twice.
using Trajectory = std::vector<TimedPose>;

/// Between the two poses around `utime`; none before the first, after the last, and where those
/// two are more than `max_gap` [s] apart.
std::optional<Position> pose_at(const Trajectory& trajectory, std::int64_t utime, double max_gap);

/// Brings poses into order of time. Of those of one utime the first stays.
void put_in_order(Trajectory& trajectory);

/// [m] driven up to each pose: 0 at the first. Straight from pose to pose.
std::vector<double> driven(const Trajectory& trajectory);

}  // namespace perceptor
