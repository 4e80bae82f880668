/// @file What a driver wishes of the base, for as long as the wish counts.
#pragma once

#include <cstdint>
#include <optional>

#include "common/geometry/twist.hpp"

namespace perceptor {

/// At most `speed` [m/s], in the same direction, and at most `turn_rate` [rad/s].
Twist within_limits(const Twist& wished, double speed, double turn_rate);

/// The newest wish. A driver that hangs or has gone must not leave the robot driving: a wish that
/// rests on measurements older than a lifetime is none.
class VelocityCommand {
 public:
  explicit VelocityCommand(double lifetime) : lifetime_(lifetime) {}  ///< [s]

  /// `measured_at` [us]: when that was measured on which the wish rests.
  void take(const Twist& wished, std::int64_t measured_at) {
    command_ = Command{wished, measured_at};
  }

  /// Whether a wish has ever come.
  bool has_come() const { return command_.has_value(); }

  /// The wish at `now` [us, the same clock], while it counts.
  std::optional<Twist> at(std::int64_t now) const;

 private:
  struct Command {
    Twist wished;
    std::int64_t measured_at;
  };

  double lifetime_;  ///< [s]
  std::optional<Command> command_;
};

}  // namespace perceptor
