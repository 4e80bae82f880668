/// @file The newest message of each channel, and the picture that they give together.
///
/// What was sent decides the picture, and nothing else does: no clock; and in between two
/// beginnings of the robot no order of arrival beyond that within a channel.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <pico/entrance_t.hpp>
#include <pico/laser_scan_t.hpp>
#include <pico/map_t.hpp>
#include <pico/position_t.hpp>
#include <pico/proximity_t.hpp>
#include <pico/truth_t.hpp>
#include <pico/world_position_t.hpp>

#include "common/geometry/twist.hpp"
#include "common/model/map.hpp"
#include "components/viewer/channel_clock.hpp"
#include "components/viewer/frames.hpp"
#include "components/viewer/scene.hpp"

namespace perceptor::viewer {

struct NewestParameters {
  double trail_step = 0.1;  ///< [m] between two points of the trail
  int trail_points = 1000;  ///< kept; the oldest go first
  double stale = 1.0;       ///< [s] a channel that is older than the newest by more is told of
};

/// Every message that is taken must be valid.
class Newest {
 public:
  explicit Newest(const NewestParameters& parameters = {}) : parameters_(parameters) {}

  void take(const pico::laser_scan_t& scan);
  void take(const pico::position_t& position);
  void take(const pico::proximity_t& proximity);
  void take(const pico::entrance_t& entrance);
  void take(const pico::world_position_t& position);
  void take(const pico::truth_t& truth);

  /// `channel`: one of those that carry maps; others are passed over.
  void take(const std::string& channel, const pico::map_t& map);

  Scene scene() const;

 private:
  /// A map that comes in parts is shown as soon as one part is there. Never without a part.
  struct Parts {
    std::int64_t map_id = 0;
    std::int32_t count = 0;
    std::map<std::int32_t, pico::map_t> there;
  };

  template <class Message>
  void hear(const std::string& channel, const Message& message);
  void begin_anew();
  bool is_of_this_zero(std::int64_t zero_utime);
  void keep(const std::string& channel, const pico::map_t& map);
  void extend_trail();
  const pico::map_t* local_map() const;
  std::vector<Item> items_of(const std::string& channel,
                             std::vector<Item> (*items_of_map)(const Map&)) const;
  void add_local_layers(Scene& scene) const;
  void add_sensor_layers(Scene& scene) const;
  void add_world_layers(Scene& scene) const;
  void add_true_layer(Scene& scene) const;
  void add_robot_layer(Scene& scene) const;
  std::optional<Item> pose_ellipse() const;
  std::vector<std::string> notes() const;

  NewestParameters parameters_;
  ChannelClock clock_;
  std::optional<std::int64_t> zero_utime_;  ///< names the zero frame: see position_t
  Frames frames_;
  std::deque<Vector2> trail_;  ///< [m] local frame
  std::map<std::string, Parts> maps_;
  std::optional<pico::position_t> position_;
  Twist twist_;  ///< over the last two positions
  std::optional<pico::laser_scan_t> scan_;
  std::optional<pico::proximity_t> proximity_;
  std::optional<pico::entrance_t> entrance_;
  std::optional<pico::world_position_t> world_position_;
  std::optional<pico::truth_t> truth_;
};

}  // namespace perceptor::viewer
