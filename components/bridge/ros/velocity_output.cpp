#include "components/bridge/ros/velocity_output.hpp"

namespace perceptor {

bool VelocityOutput::wish(const Twist& wished, std::int64_t measured_at, std::int64_t now) {
  const Twist allowed = within_limits(wished, limits_.speed, limits_.turn_rate);
  command_.take(allowed, measured_at);
  is_new_ = command_.at(now).has_value();
  return allowed.vx != wished.vx || allowed.vy != wished.vy || allowed.va != wished.va;
}

void VelocityOutput::heard_by_another(std::int64_t now) { begin_to_stop(now); }

void VelocityOutput::begin_to_stop(std::int64_t now) {
  stop_until_ = now + kStopFor;
  next_stop_ = now;
}

std::optional<Twist> VelocityOutput::due(std::int64_t now) {
  if (const auto wished = command_.at(now)) {
    if (!is_new_) return std::nullopt;
    is_new_ = false;
    is_driving_ = true;
    return wished;
  }
  if (is_driving_) begin_to_stop(now);
  is_driving_ = false;
  if (now < next_stop_ || now >= stop_until_) return std::nullopt;
  next_stop_ = now + kStopPeriod;
  return Twist{};
}

}  // namespace perceptor
