#include "components/bridge/pace.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace perceptor {

std::int64_t Pace::source_time(std::int64_t now, std::int64_t next_due) {
  if (is_unpaced()) return std::numeric_limits<std::int64_t>::max();
  if (!started_) {
    started_ = true;
    clock_anchor_ = now;
  }
  const std::int64_t late = now - clock_time(next_due, std::numeric_limits<std::int64_t>::min());
  if (late > kPatience) {
    clock_anchor_ += late;
    lost_ += late;
  }
  const auto elapsed = static_cast<double>(now - clock_anchor_);
  return source_anchor_ + static_cast<std::int64_t>(std::floor(elapsed * speed_));
}

std::int64_t Pace::clock_time(std::int64_t source_utime, std::int64_t now) const {
  if (is_unpaced()) return now;
  const double ahead = static_cast<double>(source_utime - source_anchor_) / speed_;
  return std::max(now, clock_anchor_ + static_cast<std::int64_t>(std::ceil(ahead)));
}

}  // namespace perceptor
