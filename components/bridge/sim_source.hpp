/// @file The simulator as a source: it is paced by the clock, its measurements are published,
/// and commands reach it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "common/bus/bus.hpp"
#include "common/time/stamp.hpp"
#include "components/bridge/bridge_config.hpp"
#include "components/bridge/pace.hpp"
#include "components/bridge/source.hpp"

namespace perceptor {

class SimSource : public Source {
 public:
  /// Throws config::Error where the world cannot be read. `session` numbers what is published.
  SimSource(const BridgeConfig& config, std::int64_t session, Bus& bus);

  std::int64_t step(std::int64_t now) override;

  bool finished() const override;

 private:
  void open_door(std::optional<int> door);
  void speak(const std::string& text);
  void publish(const sim::OdometryReading& reading);
  void publish(const sim::Sweep& sweep);
  void publish_world();
  void say_how_it_goes();
  std::int64_t simulated() const;

  Bus& bus_;
  std::int64_t session_;
  std::int64_t duration_;  ///< [us]; 0: for ever
  LaserMounting mounting_;
  sim::Simulator simulator_;
  Pace pace_;
  std::int64_t next_world_;  ///< [us] simulated time at which the world is published next
  std::int64_t odometries_ = 0;
  std::int64_t scans_ = 0;
  std::int64_t worlds_ = 0;
  std::string spoken_;
};

}  // namespace perceptor
