/// @file merge: CURRENT_MAP in, LOCAL_MAP out, one for one.
///
/// Begins anew, with an empty map, when CURRENT_MAP does or when its zero frame is another.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include <pico/map_t.hpp>

#include "common/bus/bus.hpp"
#include "common/config/fields.hpp"
#include "common/config/motion_noise.hpp"
#include "common/config/robot.hpp"
#include "components/merge/merger.hpp"

namespace perceptor {

struct MergeConfig {
  merge::MergeParameters merge;
  double safe_distance = 0.4;  ///< [m] of the safe-distance octagon from the robot's centre
  Robot robot;
};

namespace merge {
void describe(config::Fields& fields, SightingParameters& p);
void describe(config::Fields& fields, SameWallParameters& p);
void describe(config::Fields& fields, RegistrationParameters& p);
void describe(config::Fields& fields, EndParameters& p);
void describe(config::Fields& fields, FusionParameters& p);
void describe(config::Fields& fields, CornerParameters& p);
void describe(config::Fields& fields, ConfirmationParameters& p);
void describe(config::Fields& fields, SeesThroughParameters& p);
void describe(config::Fields& fields, ForgettingParameters& p);
}  // namespace merge

void describe(config::Fields& fields, MergeConfig& config);

class MergeComponent {
 public:
  using Config = MergeConfig;
  static constexpr std::string_view kName = "merge";
  static constexpr std::string_view kSummary =
      "merges the walls of each scan into the local map, and corrects the robot's pose by it";

  MergeComponent(const MergeConfig& config, Bus& bus);
  MergeComponent(const MergeComponent&) = delete;
  MergeComponent& operator=(const MergeComponent&) = delete;

 private:
  void on_current_map(const pico::map_t& message, bool began_anew);

  MergeConfig config_;
  Bus& bus_;
  merge::Merger merger_;
  std::optional<std::int64_t> zero_utime_;
};

}  // namespace perceptor
