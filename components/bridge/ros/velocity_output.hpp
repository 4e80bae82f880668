/// @file What a robot is told that holds each velocity until it hears another.
#pragma once

#include <cstdint>
#include <optional>

#include "common/config/robot.hpp"
#include "components/bridge/velocity_command.hpp"

namespace perceptor {

/// The driver's wishes, within the robot's limits; and to stop, again and again for a second, when
/// the wishes end and when somebody begins to listen: it may hold what a bridge before us said.
/// Otherwise silent, so that a joystick or another program can drive the robot meanwhile.
class VelocityOutput {
 public:
  static constexpr std::int64_t kStopFor = 1'000'000;  ///< [us]
  static constexpr std::int64_t kStopPeriod = 50'000;  ///< [us]

  /// `lifetime` [s] of a wish.
  VelocityOutput(const RobotLimits& limits, double lifetime)
      : limits_(limits), command_(lifetime) {}

  /// A wish that came at `now` [us, monotonic], resting on what was measured at `measured_at`, the
  /// same clock. Gives whether it goes beyond the limits.
  bool wish(const Twist& wished, std::int64_t measured_at, std::int64_t now);

  /// Somebody who may not have heard the last words listens from `now` on.
  void heard_by_another(std::int64_t now);

  /// What is to be said at `now`; none: nothing.
  std::optional<Twist> due(std::int64_t now);

 private:
  void begin_to_stop(std::int64_t now);

  RobotLimits limits_;
  VelocityCommand command_;
  bool is_driving_ = false;  ///< the robot's last word is a wish
  bool is_new_ = false;      ///< the wish has not been said
  std::int64_t stop_until_ = 0;
  std::int64_t next_stop_ = 0;
};

}  // namespace perceptor
