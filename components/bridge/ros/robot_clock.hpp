/// @file The robot's own stamps, laid on our clock.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

#include "common/time/continuity.hpp"

namespace perceptor {

/// The two clocks need not agree: what counts is how much older than the newest measurement
/// another one is.
class RobotClock {
 public:
  /// A measurement stamped `utime` [us] by the robot came in at `now` [us, monotonic].
  void saw(std::int64_t utime, std::int64_t now) {
    const bool is_newer = !newest_ || utime > newest_->utime;
    const bool began_anew = newest_ && utime < newest_->utime - ContinuityWatch::kRestartStep;
    if (is_newer || began_anew) newest_ = Newest{utime, now};
  }

  /// When [us, monotonic] something that the robot stamped `utime` came in, or would have; `now`
  /// where nothing has come yet, or only older things.
  std::int64_t arrival(std::int64_t utime, std::int64_t now) const {
    return newest_ ? std::min(now, newest_->came - (newest_->utime - utime)) : now;
  }

 private:
  struct Newest {
    std::int64_t utime;
    std::int64_t came;
  };
  std::optional<Newest> newest_;
};

}  // namespace perceptor
