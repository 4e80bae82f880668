/// @file How far a source should have come by now.
#pragma once

#include <cstdint>

namespace perceptor {

/// Lays a source's own time (simulated, or a log's) on the monotonic clock. A source that
/// cannot keep up falls behind: time is lost, and nothing comes in bursts later.
class Pace {
 public:
  /// Later than this is falling behind [us] of the clock.
  static constexpr std::int64_t kPatience = 100'000;

  /// `speed`: seconds of the source in one second of the clock; 0: as fast as it can.
  Pace(double speed, std::int64_t source_start) : speed_(speed), source_anchor_(source_start) {}

  /// The source's time at `now` [us], when the next thing to come is due at `next_due` (source
  /// time). The first call starts the clock.
  std::int64_t source_time(std::int64_t now, std::int64_t next_due);

  /// When, on the clock, a source time is due; `now` where it is due already.
  std::int64_t clock_time(std::int64_t source_utime, std::int64_t now) const;

  /// How much the source fell behind in all [us] of the clock.
  std::int64_t lost() const { return lost_; }

 private:
  bool is_unpaced() const { return speed_ == 0.0; }

  double speed_;
  bool started_ = false;
  std::int64_t clock_anchor_ = 0;
  std::int64_t source_anchor_;
  std::int64_t lost_ = 0;
};

}  // namespace perceptor
