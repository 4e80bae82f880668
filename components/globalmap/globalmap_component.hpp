/// @file globalmap: what the map file says of the building, GLOBAL_MAP each second.
///
/// out: GLOBAL_MAP, world frame, in parts where it is large. Its utime is the time of sending, a
///      microsecond later for each part; its map_id is that of the contents: the same for all who
///      read the same building, whatever the order in their file.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <pico/map_t.hpp>

#include "common/bus/bus.hpp"
#include "common/config/fields.hpp"
#include "common/global_map/global_map.hpp"

namespace perceptor {

struct GlobalmapConfig {
  std::string map = "hospital";  ///< a map's name in the folder `maps`, or its file
  global_map::GlobalMapParameters global_map;
  std::filesystem::path config_dir;  ///< set by the runner
};

void describe(config::Fields& fields, GlobalmapConfig& config);

class GlobalmapComponent {
 public:
  using Config = GlobalmapConfig;
  static constexpr std::string_view kName = "globalmap";
  static constexpr std::string_view kSummary =
      "reads the map of the building, and says each second what stands in it";
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 1> kShortcuts = {
      {{"map", "the building: a name in the folder maps, or a JSON file"}}};

  /// The bus must outlive the component. Throws config::Error where the map cannot be read.
  GlobalmapComponent(const GlobalmapConfig& config, Bus& bus);

  /// Sends the map where that has become due by `now` [us, monotonic]; gives when to be called
  /// next.
  std::int64_t step(std::int64_t now);
  static bool finished() { return false; }

 private:
  Bus& bus_;
  std::vector<pico::map_t> parts_;
  std::int64_t session_;
  std::int64_t seq_ = 0;
  std::int64_t next_ = 0;  ///< [us] monotonic
};

}  // namespace perceptor
