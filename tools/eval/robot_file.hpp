/// @file The robot as the bridge's configuration has it.
#pragma once

#include <filesystem>

#include "components/bridge/bridge_config.hpp"

namespace perceptor {

/// Of a folder of configuration files. Throws config::Error.
inline Robot read_robot(const std::filesystem::path& config_dir) {
  BridgeConfig bridge;
  config::load({config_dir / "bridge.json", config_dir / "robot.json", {}},
               [&](config::Fields& fields) { describe(fields, bridge); });
  return bridge.robot;
}

}  // namespace perceptor
