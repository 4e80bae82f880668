/// @file Names what the local map shows: convex and concave corners, doors and possible doors;
/// and says which door is the way out, and whether the robot is in a hallway.
///
/// in:  LOCAL_MAP
/// out: IDENTIFIED_MAP, and then ENTRANCE, one of each for each LOCAL_MAP
///
/// An entrance is the median of the last maps. That memory begins anew when LOCAL_MAP does or
/// when its zero frame is another.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include <pico/entrance_t.hpp>
#include <pico/map_t.hpp>

#include "common/bus/bus.hpp"
#include "components/identify/entrance_tracker.hpp"
#include "components/identify/identify_config.hpp"

namespace perceptor {

class IdentifyComponent {
 public:
  static constexpr std::string_view kName = "identify";
  static constexpr std::string_view kSummary =
      "names the local map's corners, doors and possible doors, the way out, and a hallway";
  using Config = IdentifyConfig;

  /// The bus must outlive the component.
  IdentifyComponent(const IdentifyConfig& config, Bus& bus);

 private:
  void take(const pico::map_t& local_map);
  pico::entrance_t entrance_of(const pico::map_t& local_map, const Map& identified);

  Bus& bus_;
  IdentifyConfig config_;
  identify::EntranceTracker entrances_;
  std::optional<std::int64_t> zero_utime_;
};

}  // namespace perceptor
