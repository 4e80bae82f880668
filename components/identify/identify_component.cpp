#include "components/identify/identify_component.hpp"

#include "common/bus/channels.hpp"
#include "common/messages/convert.hpp"
#include "common/messages/validate.hpp"

namespace perceptor {
namespace {

/// Five seconds of maps at 40 Hz: after a stall none is lost, and nobody waits on old ones for
/// long, because a map takes less than a tenth of a millisecond.
constexpr int kMapCapacity = 200;

bool fits_one_message(const pico::map_t& message) {
  return message.getEncodedSize() <= static_cast<int>(kMaxPayload) &&
         message.num_points <= messages::kMaxMapPoints &&
         message.num_objects <= messages::kMaxMapObjects;
}

void describe_openings(config::Fields& fields, identify::OpeningParameters& p) {
  fields.number("door_min_width", p.door_min_width, {0.1, 10.0},
                "[m] less takes gaps that no robot drives through for doors");
  fields.number("door_max_width", p.door_max_width, {0.1, 10.0},
                "[m] more takes the ends of corridors for doors");
  fields.number("wall_min_length", p.wall_min_length, {0.0, 10.0},
                "[m] shorter walls bound no door: their direction is unsure");
  fields.number("max_angle", p.max_angle, {0.0, 1.5},
                "[rad] of each wall with the line through the two ends");
  fields.number("max_offset", p.max_offset, {0.0, 10.0},
                "[m] of each end from the line of the other wall");
  fields.number("max_face_angle", p.max_face_angle, {0.0, 1.5},
                "[rad] by which an end's wall may miss the normal of the wall it faces, or a "
                "jamb that of the door's line");
  fields.number("end_tolerance", p.end_tolerance, {0.0, 1.0},
                "[m] within this of its ends, a wall that only touches a door's line does not "
                "shut it (a jamb)");
  fields.number("shut_depth_behind", p.shut_depth_behind, {0.0, 10.0},
                "[m] a wall across a door this close behind shuts it; more loses doors onto narrow "
                "corridors");
  fields.number("shut_depth_before", p.shut_depth_before, {0.0, 10.0}, "[m] the same before it");
  fields.number("shut_share", p.shut_share, {0.0, 1.0},
                "of the width that such a wall must stand across");
  fields.number(
      "max_wall_thickness", p.max_wall_thickness, {0.0, 10.0},
      "[m] between two faces of one wall; more takes two doors behind each other for one");
}

}  // namespace

void identify::describe(config::Fields& fields, ConfidenceParameters& parameters) {
  ConfidenceParameters& p = parameters;
  fields.number("outer_end", p.outer_end, {0.0, 1.0},
                "factor for an end that was seen from one side only");
  fields.number("turned_end", p.turned_end, {0.0, 1.0},
                "factor for an end that turns into something too short to be a wall");
  fields.number("loose_end", p.loose_end, {0.0, 1.0}, "factor for an end that may not be one");
  fields.number("face", p.face, {0.0, 1.0}, "factor for the face of a wall");
  fields.number("one_side_unknown", p.one_side_unknown, {0.0, 1.0},
                "factor where it is not sure that both walls face alike");
  fields.number("angle_share", p.angle_share, {0.0, 1.0}, "lost at the limit of the angle");
  fields.number("offset_share", p.offset_share, {0.0, 1.0}, "lost at the limit of the offset");
  fields.number("width_share", p.width_share, {0.0, 1.0}, "lost at the limits of the width");
  fields.number("usual_width", p.usual_width, {0.1, 10.0},
                "[m] of a door; nothing is lost at this width");
}

void describe(config::Fields& fields, IdentifyConfig& config) {
  identify::IdentifyParameters& p = config.identify;
  fields.number("straight_angle", p.corners.straight_angle, {0.0, 1.5},
                "[rad] two walls that turn by less are no corner; more leaves flat corners without "
                "a type");
  fields.boolean("jump_is_convex", p.corners.jump_is_convex,
                 "a loose end at the nearer side of a jump in range counts as convex");
  describe_openings(fields, p.openings);
  fields.group("confidence", p.confidence, "how the confidence of a door is made");
}

IdentifyComponent::IdentifyComponent(const IdentifyConfig& config, Bus& bus)
    : bus_(bus), parameters_(config.identify) {
  bus_.subscribe<pico::map_t>(
      channel::local_map, kMapCapacity,
      [this](const pico::map_t& local_map, bool /*began_anew*/) { take(local_map); });
}

void IdentifyComponent::take(const pico::map_t& local_map) {
  const Vector2 robot = Vector2::Zero();  // the local map comes in the robot frame
  Map map = to_model(local_map);
  std::size_t openings = identify::identify(map, robot, parameters_);

  pico::map_t identified_map = local_map;
  set_map(identified_map, map);
  while (!fits_one_message(identified_map) && openings > 0) {
    bus_.count(channel::identified_map, "opening left out of a full map", 1);
    identify::remove_last_opening(map);
    --openings;
    set_map(identified_map, map);
  }
  bus_.publish(channel::identified_map, identified_map);
}

}  // namespace perceptor
