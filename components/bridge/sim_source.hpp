/// @file The simulator as a source: it is paced by the clock, its measurements are published,
/// and commands reach it.
#pragma once

#include <cstdint>
#include <string>

#include <pico/open_door_t.hpp>
#include <pico/speak_t.hpp>
#include <pico/velocity_t.hpp>

#include "common/bus/bus.hpp"
#include "common/time/stamp.hpp"
#include "components/bridge/bridge_config.hpp"
#include "components/bridge/pace.hpp"

namespace perceptor {

class SimSource {
 public:
  /// Throws config::Error where the world cannot be read. `session` numbers what is published.
  SimSource(const BridgeConfig& config, std::int64_t session, Bus& bus);

  /// Simulates what has become due by `now` [us, monotonic], though not more than a little at a
  /// time; gives when to be called next.
  std::int64_t step(std::int64_t now);

  bool finished() const;

 private:
  void take(const pico::velocity_t& command);
  void take(const pico::open_door_t& request);
  void take(const pico::speak_t& speech);
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
