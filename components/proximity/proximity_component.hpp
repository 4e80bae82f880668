/// @file What is too close to the robot, one PROXIMITY for each scan. It does not wait for
/// odometry: a warning must not.
///
/// in:  PICO_LASER
/// out: PROXIMITY
#pragma once

#include <string_view>
#include <vector>

#include "common/bus/bus.hpp"
#include "common/config/fields.hpp"
#include "common/config/robot.hpp"
#include "components/proximity/surroundings.hpp"

namespace perceptor {

struct ProximityConfig {
  ProximityParameters proximity;
  Robot robot;
};

void describe(config::Fields& fields, ProximityConfig& config);

class ProximityComponent {
 public:
  static constexpr std::string_view kName = "proximity";
  static constexpr std::string_view kSummary =
      "says in which directions something is too close, and in which it sees nothing";
  using Config = ProximityConfig;

  /// The bus must outlive the component.
  ProximityComponent(const ProximityConfig& config, Bus& bus);

 private:
  void take(const pico::laser_scan_t& message);

  Bus& bus_;
  ProximityParameters parameters_;
  std::vector<Vector2> footprint_;  // [m] robot frame
};

}  // namespace perceptor
