#include "components/locate/locate_component.hpp"

#include <string>

#include <pico/odometry_t.hpp>
#include <pico/position_t.hpp>

#include "common/bus/channels.hpp"
#include "common/messages/convert.hpp"
#include "common/time/stamp.hpp"

namespace perceptor {
namespace {

/// Every odometry matters: what waits while the process stalls for 20 s at 50 Hz is kept.
constexpr int kOdometryCapacity = 1000;

}  // namespace

void describe(config::Fields& fields, LocateConfig& config) {
  ZeroFrameParameters& p = config.zero_frame;
  fields.number("max_speed", p.max_speed, {0.0, 100.0},
                "[m/s] a faster step of the odometry is a jump; more lets larger jumps pass");
  fields.number("distance_slack", p.distance_slack, {0.0, 10.0},
                "[m] allowed on top of that, because stamps are coarse");
  fields.number("max_turn_rate", p.max_turn_rate, {0.0, 100.0},
                "[rad/s] a faster turn is a jump; more lets larger jumps pass");
  fields.number("heading_slack", p.heading_slack, {0.0, 3.2},
                "[rad] allowed on top of that, because stamps are coarse");
  fields.number("origin_radius", p.origin_radius, {0.0, 1.0},
                "[m] a jump to this near the odometry's origin: the robot was switched on anew");
  fields.number("origin_heading", p.origin_heading, {0.0, 3.2},
                "[rad] and with a heading this near to zero");
}

LocateComponent::LocateComponent(const LocateConfig& config, Bus& bus)
    : bus_(bus), zero_frame_(config.zero_frame) {
  bus_.subscribe<pico::odometry_t>(
      channel::odometry, kOdometryCapacity,
      [this](const pico::odometry_t& odometry, bool began_anew) { take(odometry, began_anew); });
}

void LocateComponent::take(const pico::odometry_t& odometry, bool began_anew) {
  const Position robot_in_odometry = to_model(odometry.robot_in_odometry);
  const ZeroPosition now = zero_frame_.update(odometry.utime, robot_in_odometry, began_anew);
  report_jump(now.step, now.bridged);

  pico::position_t position{};
  set_stamp(position, stamp_of(odometry));
  position.zero_utime = now.zero_utime;
  position.zero_in_odometry = to_message(now.zero_in_odometry);
  position.robot_in_zero = to_message(now.robot_in_zero);
  position.bridged = now.bridged;
  bus_.publish(channel::position, position);
}

void LocateComponent::report_jump(OdometryStep step, int bridged) {
  switch (step) {
    case OdometryStep::first:
      return bus_.status().set_note("");
    case OdometryStep::driven:
      return;
    case OdometryStep::jumped:
      bus_.count(channel::odometry, "jump bridged", 1);
      break;
    case OdometryStep::switched_on_anew:
      bus_.count(channel::odometry, "robot switched on anew, bridged", 1);
      break;
  }
  bus_.status().set_note("jumps of the odometry bridged in this session: " +
                         std::to_string(bridged));
}

}  // namespace perceptor
