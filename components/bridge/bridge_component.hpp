/// @file The robot as the other processes see it: raw measurements from the simulator, from a
/// recorded log or from a robot that speaks ROS 1, and commands back to it.
///
/// in:  CMD_VELOCITY, CMD_OPEN_DOOR, CMD_SPEAK (simulator, ROS)
/// out: PICO_LASER, PICO_ODOMETRY; the simulator also SIM_TRUTH, SIM_WORLD; a log whatever
///      PICO_* it holds
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string_view>
#include <utility>

#include "common/bus/bus.hpp"
#include "components/bridge/bridge_config.hpp"
#include "components/bridge/source.hpp"

namespace perceptor {

class BridgeComponent {
 public:
  static constexpr std::string_view kName = "bridge";
  static constexpr std::string_view kSummary =
      "publishes raw laser and odometry, from the simulator, a recorded log or a robot";
  /// Command-line options that stand for a configuration key.
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 4> kShortcuts = {{
      {"source", "sim (the simulator), log:FILE (an LCM log), or ros (a robot that speaks ROS 1)"},
      {"world", "of the simulator: a world's name, or its file"},
      {"speed", "times real time; 0: as fast as it can"},
      {"duration", "[s] of the source's own time, then stop; 0: for ever"},
  }};
  using Config = BridgeConfig;

  /// The bus must outlive the component. Throws config::Error: no such source, or none in this
  /// build; a world or a log that cannot be read.
  BridgeComponent(const BridgeConfig& config, Bus& bus);

  /// Does what has become due by `now` [us, monotonic]; gives when to be called next.
  std::int64_t step(std::int64_t now) { return source_->step(now); }

  /// Nothing more will come: the duration is over, or the log at its end.
  bool finished() const { return source_->finished(); }

  /// Brings what moves to rest.
  void stop() { source_->stop(); }

 private:
  std::unique_ptr<Source> source_;
};

}  // namespace perceptor
