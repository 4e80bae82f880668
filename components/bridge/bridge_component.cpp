#include "components/bridge/bridge_component.hpp"

#include <chrono>
#include <string>
#include <utility>

#include "components/bridge/log_source.hpp"
#include "components/bridge/ros/master_probe.hpp"
#include "components/bridge/ros/ros_link.hpp"
#include "components/bridge/ros_source.hpp"
#include "components/bridge/sim_source.hpp"

namespace perceptor {
namespace {

constexpr std::string_view kLogPrefix = "log:";

/// The one place where the bridge looks at the wall clock: two starts are two sessions.
std::int64_t session_of(const BridgeConfig& config) {
  if (config.session != 0) return config.session;
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::microseconds>(now).count();
}

std::unique_ptr<Source> make_ros_source(const BridgeConfig& config, Bus& bus) {
  const std::string master = master_uri(config.ros);
  if (!parse_master_uri(master))
    throw config::Error("ROS_MASTER_URI is \"" + master + "\"; allowed: http://HOST:PORT");
  auto link = make_ros_link(config.ros, master);
  if (!link)
    throw config::Error(
        "/source: \"ros\": this pico-bridge was built without ROS 1. As root, or with sudo:\n"
        "  apt install libroscpp-dev libsensor-msgs-dev libnav-msgs-dev\n"
        "then configure and build again (tools/run --source ros does all of that)");
  return std::make_unique<RosSource>(config, session_of(config), bus, std::move(link));
}

std::unique_ptr<Source> make_source(const BridgeConfig& config, Bus& bus) {
  if (config.source == "sim") return std::make_unique<SimSource>(config, session_of(config), bus);
  if (config.source == "ros") return make_ros_source(config, bus);
  if (config.source.starts_with(kLogPrefix))
    return std::make_unique<LogSource>(config.source.substr(kLogPrefix.size()), config.speed,
                                       config.duration, bus);
  throw config::Error("/source: \"" + config.source +
                      "\" is no source; sources are: sim, log:FILE, ros");
}

}  // namespace

BridgeComponent::BridgeComponent(const BridgeConfig& config, Bus& bus)
    : source_(make_source(config, bus)) {}

}  // namespace perceptor
