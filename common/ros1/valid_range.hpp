/// @file Which ranges of a sensor_msgs/LaserScan are returns.
#pragma once

#include <algorithm>

namespace perceptor::ros1 {

/// Both ends are returns.
struct ValidRange {
  double min = 0.0;  ///< [m]
  double max = 0.0;  ///< [m]
};

/// [m] TU/e's simulators scatter a miss by 0.01 to either side.
inline constexpr double kMissNoise = 0.015;

/// Robots say "no return" with a range of 0, of infinity or of range_max, the first and the last
/// with a little noise on top: so what is valid goes from range_min to range_max [m], but for what
/// is within `miss_noise` [m] of 0 or of range_max.
inline ValidRange valid_range(double range_min, double range_max, double miss_noise) {
  return {std::max(range_min, miss_noise), range_max - miss_noise};
}

}  // namespace perceptor::ros1
