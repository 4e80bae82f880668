/// @file Where the robot is in the zero frame, one POSITION for each odometry.
///
/// in:  PICO_ODOMETRY
/// out: POSITION
#pragma once

#include <string_view>

#include "common/bus/bus.hpp"
#include "common/config/fields.hpp"
#include "components/locate/zero_frame.hpp"

namespace perceptor {

struct LocateConfig {
  ZeroFrameParameters zero_frame;
};

void describe(config::Fields& fields, LocateConfig& config);

class LocateComponent {
 public:
  static constexpr std::string_view kName = "locate";
  static constexpr std::string_view kSummary =
      "says where the robot is, seen from where it was at the first odometry";
  using Config = LocateConfig;

  /// The bus must outlive the component.
  LocateComponent(const LocateConfig& config, Bus& bus);

 private:
  void take(const pico::odometry_t& odometry, bool began_anew);
  void report_jump(OdometryStep step, int bridged);

  Bus& bus_;
  ZeroFrame zero_frame_;
};

}  // namespace perceptor
