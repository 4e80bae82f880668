/// @file viewer: the newest of every channel as one picture, in a browser.
///
/// in:  PICO_LASER, POSITION, PROXIMITY, CURRENT_MAP, LOCAL_MAP, IDENTIFIED_MAP, ENTRANCE,
///      GLOBAL_MAP, WORLD_POSITION, COMBINED_MAP, SIM_TRUTH, SIM_WORLD, STATUS_*
/// out: nothing on the bus but its own STATUS; the page at http://ADDRESS:PORT
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include <pico/status_t.hpp>

#include "common/bus/bus.hpp"
#include "common/config/fields.hpp"
#include "components/viewer/newest.hpp"
#include "components/viewer/scene_server.hpp"

namespace perceptor {

struct ViewerConfig {
  viewer::ServerParameters server;
  viewer::NewestParameters newest;
  double rate = 10.0;  ///< [Hz] scenes to each browser
};

void describe(config::Fields& fields, ViewerConfig& config);

class ViewerComponent {
 public:
  using Config = ViewerConfig;
  static constexpr std::string_view kName = "viewer";
  static constexpr std::string_view kSummary =
      "shows the robot, its beams and all maps as one live picture in a browser";
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 2> kShortcuts = {
      {{"port", "of the page: http://127.0.0.1:8080 by default"},
       {"address", "to listen on; 0.0.0.0 for every network, where anybody may look"}}};

  /// The bus must outlive the component. Throws std::runtime_error where the port is not to be had.
  ViewerComponent(const ViewerConfig& config, Bus& bus);

  /// Makes a scene where somebody looks and one has become due by `now` [us, monotonic]; gives
  /// when to be called next.
  std::int64_t step(std::int64_t now);
  static bool finished() { return false; }

 private:
  std::int64_t period_;  ///< [us]
  std::int64_t next_ = 0;
  viewer::Newest newest_;
  std::map<std::string, pico::status_t> statuses_;
  viewer::SceneServer server_;
};

}  // namespace perceptor
