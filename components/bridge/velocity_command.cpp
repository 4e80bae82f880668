#include "components/bridge/velocity_command.hpp"

#include <algorithm>

#include "common/time/stamp.hpp"

namespace perceptor {

Twist within_limits(const Twist& wished, double speed, double turn_rate) {
  const double wished_speed = Vector2(wished.vx, wished.vy).norm();
  const double scale = wished_speed > speed ? speed / wished_speed : 1.0;
  return {wished.vx * scale, wished.vy * scale, std::clamp(wished.va, -turn_rate, turn_rate)};
}

std::optional<Twist> VelocityCommand::at(std::int64_t now) const {
  if (!command_ || seconds_between(command_->measured_at, now) > lifetime_) return std::nullopt;
  return command_->wished;
}

}  // namespace perceptor
