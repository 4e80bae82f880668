#include "components/identify/identify_component.hpp"

#include <vector>

#include "common/bus/channels.hpp"
#include "common/messages/convert.hpp"
#include "common/messages/validate.hpp"
#include "common/time/stamp.hpp"
#include "components/identify/entrance.hpp"
#include "components/identify/walls.hpp"

namespace perceptor {
namespace {

/// Five seconds of maps at 40 Hz: after a stall none is lost, and nobody waits on old ones for
/// long, because a map takes less than a tenth of a millisecond.
constexpr int kMapCapacity = 200;

/// The local map comes in the robot frame.
const Vector2 kRobot = Vector2::Zero();

bool fits_one_message(const pico::map_t& message) {
  return message.getEncodedSize() <= static_cast<int>(kMaxPayload) &&
         message.num_points <= messages::kMaxMapPoints &&
         message.num_objects <= messages::kMaxMapObjects;
}

pico::entrance_t to_message(const Stamp& stamp, const std::optional<identify::Exit>& entrance,
                            const std::optional<identify::Hallway>& hallway) {
  pico::entrance_t message{};
  set_stamp(message, stamp);
  if (entrance) {
    message.entrance_found = 1;
    message.middle_x = entrance->middle.x();
    message.middle_y = entrance->middle.y();
    message.direction = entrance->direction;
    message.width = entrance->width;
    message.confidence = entrance->confidence;
  }
  if (hallway) {
    message.in_hallway = 1;
    message.centre_x1 = hallway->back.x();
    message.centre_y1 = hallway->back.y();
    message.centre_x2 = hallway->front.x();
    message.centre_y2 = hallway->front.y();
    message.hallway_width = hallway->width;
  }
  return message;
}

}  // namespace

IdentifyComponent::IdentifyComponent(const IdentifyConfig& config, Bus& bus)
    : bus_(bus), config_(config), entrances_(config.entrance) {
  bus_.subscribe<pico::map_t>(channel::local_map, kMapCapacity,
                              [this](const pico::map_t& local_map, bool began_anew) {
                                if (began_anew || local_map.zero_utime != zero_utime_)
                                  entrances_.clear();
                                zero_utime_ = local_map.zero_utime;
                                take(local_map);
                              });
}

void IdentifyComponent::take(const pico::map_t& local_map) {
  Map map = to_model(local_map);
  std::size_t openings = identify::identify(map, kRobot, config_.identify);

  pico::map_t identified_map = local_map;
  set_map(identified_map, map);
  while (!fits_one_message(identified_map) && openings > 0) {
    bus_.count(channel::identified_map, "opening left out of a full map", 1);
    identify::remove_last_opening(map);
    --openings;
    set_map(identified_map, map);
  }
  bus_.publish(channel::identified_map, identified_map);
  bus_.publish(channel::entrance, entrance_of(local_map, map));
}

pico::entrance_t IdentifyComponent::entrance_of(const pico::map_t& local_map,
                                                const Map& identified) {
  // What stands in the way may be in another part.
  const bool shows_all = local_map.parts == 1;
  if (!shows_all) {
    bus_.count(channel::entrance, "no entrance from a map in parts", 1);
    entrances_.clear();
    return to_message(stamp_of(local_map), std::nullopt, std::nullopt);
  }
  const std::vector<identify::Wall> walls = identify::read_walls(identified);
  const auto exits =
      identify::find_exits(identified, walls, kRobot, local_map.utime, config_.entrance);
  const auto entrance =
      entrances_.update(local_map.utime, to_model(local_map.robot_in_local), exits);
  const auto hallway = identify::find_hallway(walls, kRobot, config_.hallway);
  return to_message(stamp_of(local_map), entrance, hallway);
}

}  // namespace perceptor
