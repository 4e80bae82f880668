#include "components/bridge/ros/ros_config.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <string_view>

#include "components/bridge/ros/master_probe.hpp"

namespace perceptor {
namespace {

constexpr config::Range kDistance{0.0, 1000.0};

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// Letters, digits and underscores, a letter first: what ROS allows.
bool is_node_name(std::string_view name) {
  return !name.empty() && is_letter(name.front()) &&
         std::ranges::all_of(name, [](char c) { return is_letter(c) || is_digit(c) || c == '_'; });
}

/// The same, in parts behind slashes.
bool is_topic(std::string_view name) {
  if (!name.starts_with('/')) return false;
  while (!name.empty()) {
    name.remove_prefix(1);
    const std::string_view part = name.substr(0, name.find('/'));
    if (!is_node_name(part)) return false;
    name.remove_prefix(part.size());
  }
  return true;
}

void topic(config::Fields& fields, std::string_view key, std::string& value,
           std::string_view help) {
  fields.text(key, value, help);
  fields.require(is_topic(value), key, "a topic's whole name, as \"/pico/laser\"");
}

}  // namespace

void describe(config::Fields& fields, RosLaser& laser) {
  topic(fields, "topic", laser.topic, "of sensor_msgs/LaserScan");
  fields.text("frame", laser.frame, R"(frame_id that is taken (PICO's: "pico/laser"); "": any)");
  fields.number("miss_noise", laser.miss_noise, {0.0, 1.0},
                "[m] ranges so near to 0 or to range_max are no return");
  fields.number("valid_min", laser.valid_min, kDistance,
                "[m] shorter is no return; 0: range_min of the messages");
  fields.number("valid_max", laser.valid_max, kDistance,
                "[m] longer is no return; 0: range_max of the messages, less miss_noise");
}

void describe(config::Fields& fields, RosOdometry& odometry) {
  topic(fields, "topic", odometry.topic, "of nav_msgs/Odometry");
  fields.text("frame", odometry.frame, "frame_id that is taken; \"\": any");
}

void describe(config::Fields& fields, RosCommands& commands) {
  topic(fields, "velocity", commands.velocity, "of geometry_msgs/Twist");
  topic(fields, "open_door", commands.open_door, "of std_msgs/Empty");
  topic(fields, "speak", commands.speak, "of std_msgs/String");
  fields.number("lifetime", commands.lifetime, {0.02, 10.0},
                "[s] an older command stops the robot");
}

void describe(config::Fields& fields, RosParameters& ros) {
  fields.text("master", ros.master, R"("http://HOST:PORT"; "": as ROS_MASTER_URI says)");
  fields.require(ros.master.empty() || parse_master_uri(ros.master).has_value(), "master",
                 R"("http://HOST:PORT", or "")");
  fields.text("node", ros.node, "our name among ROS's nodes");
  fields.require(is_node_name(ros.node), "node", "letters, digits and _, a letter first");
  fields.number("stale_after", ros.stale_after, {0.1, 60.0},
                "[s] without a message; then the topic is subscribed to anew");
  fields.group("laser", ros.laser, "what comes from the laser");
  fields.group("odometry", ros.odometry, "what comes from the wheels");
  fields.group("commands", ros.commands, "what goes to the robot");
}

std::string master_uri(const RosParameters& ros) {
  if (!ros.master.empty()) return ros.master;
  const char* uri = std::getenv("ROS_MASTER_URI");
  return uri != nullptr && *uri != '\0' ? uri : "http://localhost:11311";
}

}  // namespace perceptor
