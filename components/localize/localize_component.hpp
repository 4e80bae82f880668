/// @file localize: where the robot is in the known building, one WORLD_POSITION for each
/// LOCAL_MAP, and what it found of that building, a COMBINED_MAP now and then.
///
/// in:  PICO_LASER, CURRENT_MAP and LOCAL_MAP of the same scan, GLOBAL_MAP (only its id)
/// out: WORLD_POSITION, COMBINED_MAP
///
/// The map file is read here too, so that localize needs nobody else to be there; GLOBAL_MAP tells
/// whether all speak of the same one.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <pico/laser_scan_t.hpp>
#include <pico/map_t.hpp>
#include <pico/world_position_t.hpp>

#include "common/bus/bus.hpp"
#include "common/config/fields.hpp"
#include "common/config/motion_noise.hpp"
#include "common/global_map/global_map.hpp"
#include "components/localize/combined_map.hpp"
#include "components/localize/localizer.hpp"

namespace perceptor {

struct LocalizeConfig {
  enum class Start { anywhere, start_area, pose };

  /// What is known of where the robot starts.
  struct StartConfig {
    Start from = Start::anywhere;
    Position pose;          ///< world frame
    double distance = 0.5;  ///< [m] from the pose, or outside the area
    double angle = 0.5;     ///< [rad] from the pose
  };

  std::string map = "hospital";  ///< a map's name in the folder `maps`, or its file
  StartConfig start;
  localize::LocalizerParameters localize;
  localize::CombinedMapParameters combined;
  double combined_period = 0.2;      ///< [s] of scans from one COMBINED_MAP to the next
  std::filesystem::path config_dir;  ///< set by the runner
};

namespace localize {
void describe(config::Fields& fields, CandidateParameters& p);
void describe(config::Fields& fields, AlignmentParameters& p);
void describe(config::Fields& fields, BeamFitParameters& p);
void describe(config::Fields& fields, SearchParameters& p);
void describe(config::Fields& fields, KeyframeParameters& p);
void describe(config::Fields& fields, ClaimParameters& p);
void describe(config::Fields& fields, WatchParameters& p);
void describe(config::Fields& fields, UnknownObjectParameters& p);
void describe(config::Fields& fields, CombinedMapParameters& p);
}  // namespace localize

void describe(config::Fields& fields, LocalizeConfig::StartConfig& start);
void describe(config::Fields& fields, LocalizeConfig& config);

class LocalizeComponent {
 public:
  using Config = LocalizeConfig;
  static constexpr std::string_view kName = "localize";
  static constexpr std::string_view kSummary =
      "finds the robot in the known building, and follows it";
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 1> kShortcuts = {
      {{"map", "the building: a name in the folder maps, or a JSON file"}}};

  /// Throws config::Error where the map cannot be read. The bus must outlive the component.
  LocalizeComponent(const LocalizeConfig& config, Bus& bus);
  LocalizeComponent(const LocalizeComponent&) = delete;
  LocalizeComponent& operator=(const LocalizeComponent&) = delete;

 private:
  LocalizeComponent(const LocalizeConfig& config, const global_map::GlobalMap& building, Bus& bus);
  void take_scan(const pico::laser_scan_t& scan, bool began_anew);
  void take_current_map(const pico::map_t& map, bool began_anew);
  void take_local_map(const pico::map_t& map, bool began_anew);
  bool is_whole(const std::string& channel, const pico::map_t& map);
  void check_id(const pico::map_t& global_map);
  void settle();
  void locate(const pico::laser_scan_t& scan, const pico::map_t& current, const pico::map_t& map);
  void combine(const localize::WorldPosition& position, const localize::Sight& sight,
               std::int64_t session);

  Bus& bus_;
  std::int64_t map_id_;
  double combined_period_;
  localize::World world_;
  localize::Localizer localizer_;
  localize::CombinedMap combined_;
  bool was_tracking_ = false;
  std::optional<std::int64_t> combined_at_;  ///< [us] utime of the last COMBINED_MAP
  std::int64_t combined_maps_ = 0;           ///< messages so far
  std::deque<pico::laser_scan_t> scans_;     ///< whose maps may still come
  std::deque<pico::map_t> currents_;         ///< whose local map may still come
  std::deque<pico::map_t> maps_;             ///< local ones, whose scan may still come
  std::optional<pico::map_t> last_map_;      ///< without objects and points
};

}  // namespace perceptor
