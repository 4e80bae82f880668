#include "components/merge/merge_component.hpp"

#include <utility>

#include "common/bus/channels.hpp"
#include "common/messages/convert.hpp"
#include "common/time/stamp.hpp"
#include "components/merge/markers.hpp"

namespace perceptor {
namespace {

constexpr int kQueue = 200;  // every scan counts: the map is made of all of them
constexpr std::string_view kWrongFrame = "not in the robot frame";
constexpr std::string_view kInParts = "in parts";
constexpr std::string_view kDoesNotFit = "does not fit the local map: not merged";

pico::map_t to_message(const pico::map_t& current, const merge::LocalMap& local, const Map& map) {
  pico::map_t message = make_map_message("robot", map);
  set_stamp(message, stamp_of(current));
  message.map_id = current.map_id;
  message.zero_utime = current.zero_utime;
  message.robot_in_zero = current.robot_in_zero;
  message.laser_in_robot = current.laser_in_robot;
  message.robot_in_local = to_message(local.robot_in_local.pose);
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      message.robot_in_local_covariance[3 * row + column] =
          local.robot_in_local.covariance(row, column);
  message.unobservable = local.unobservable_direction ? 1 : 0;
  message.unobservable_direction = local.unobservable_direction.value_or(0.0);
  return message;
}

}  // namespace

MergeComponent::MergeComponent(const MergeConfig& config, Bus& bus)
    : config_(config), bus_(bus), merger_(config.merge) {
  bus_.subscribe<pico::map_t>(
      channel::current_map, kQueue,
      [this](const pico::map_t& message, bool began_anew) { on_current_map(message, began_anew); });
}

void MergeComponent::on_current_map(const pico::map_t& message, bool began_anew) {
  if (began_anew || zero_utime_ != message.zero_utime) merger_.clear();
  zero_utime_ = message.zero_utime;
  if (message.frame != "robot") return bus_.reject(channel::current_map, kWrongFrame);
  if (message.parts != 1) return bus_.reject(channel::current_map, kInParts);

  merge::ScanMap scan;
  scan.utime = message.utime;
  scan.robot_in_zero = to_model(message.robot_in_zero);
  scan.laser_in_robot = to_model(message.laser_in_robot);
  scan.walls = to_model(message);
  merge::LocalMap local = merger_.update(scan);
  if (local.rejected) bus_.count(channel::current_map, kDoesNotFit, 1);

  Map map = std::move(local.walls);
  merge::add_origin(map, local.robot_in_local.pose);
  merge::add_robot(map, outline(config_.robot));
  merge::add_safe_distance(map, config_.safe_distance);
  bus_.publish(channel::local_map, to_message(message, local, map));
}

}  // namespace perceptor
