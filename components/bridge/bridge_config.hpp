/// @file What can be configured of the bridge.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "common/config/fields.hpp"
#include "common/config/robot.hpp"
#include "components/bridge/ros/ros_config.hpp"
#include "components/bridge/sim/simulator.hpp"

namespace perceptor {

struct BridgeConfig {
  std::string source = "sim";                ///< "sim", "log:FILE" or "ros"
  std::string world = "hospital";            ///< a world's name, or its file
  double speed = 1.0;                        ///< times real time; 0: as fast as it can
  double duration = 0.0;                     ///< [s] of the source's time; 0: for ever
  std::int64_t session = 0;                  ///< 0: the wall clock at start
  std::int64_t seed = 0;                     ///< 0: the world's own
  sim::Drive drive = sim::Drive::automatic;  ///< who drives the simulated robot
  RosParameters ros;
  Robot robot;
  std::filesystem::path config_dir;  ///< set by the runner
};

void describe(config::Fields& fields, BridgeConfig& config);

}  // namespace perceptor
