#include "components/identify/identify_config.hpp"

namespace perceptor {
namespace {

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
  fields.number("max_jamb_length", p.max_jamb_length, {0.0, 100.0},
                "[m] of the shorter of two jambs between which the robot stands; more takes the "
                "ends of corridors for doors");
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

void identify::describe(config::Fields& fields, EntranceParameters& parameters) {
  EntranceParameters& p = parameters;
  fields.number("max_distance", p.max_distance, {0.0, 100.0},
                "[m] from the robot; doors further away are not looked at");
  fields.number("max_unseen", p.max_unseen, {0.0, 1000.0},
                "[s] since a door's walls were last seen; more trusts what may have been shut, "
                "less forgets while the robot turns");
  fields.integer("scans", p.scans, {1, 1000},
                 "the last ones that are looked at; more is steadier and later");
  fields.number("max_age", p.max_age, {0.0, 60.0},
                "[s] older scans are forgotten; a laser slower than 6 Hz needs more");
  fields.number("min_share", p.min_share, {0.0, 1.0},
                "of 'scans' that must agree; less names an entrance sooner, and a wrong one too");
  fields.number("min_confidence", p.min_confidence, {0.0, 1.0},
                "of a door; less takes doubtful ones for the way out");
  fields.number("half_distance", p.half_distance, {0.1, 100.0},
                "[m] at which a door is worth half; less prefers near ones");
  fields.number("same_opening", p.same_opening, {0.0, 10.0},
                "[m] between sightings of one opening; more mixes neighbouring doors");
  fields.number("max_scatter", p.max_scatter, {0.0, 10.0},
                "[m] from the median, of middle and width, that still agrees");
  fields.number("max_turn", p.max_turn, {0.0, 1.5}, "[rad] the same of the direction");
  fields.number("switch_gain", p.switch_gain, {1.0, 100.0},
                "times better that another opening must be to take over");
}

void identify::describe(config::Fields& fields, HallwayParameters& parameters) {
  HallwayParameters& p = parameters;
  fields.number("max_angle", p.max_angle, {0.0, 1.5}, "[rad] of a wall with the centre line");
  fields.number("min_width", p.min_width, {0.0, 100.0}, "[m] less is no place to drive");
  fields.number("max_width", p.max_width, {0.0, 100.0}, "[m] more takes rooms for hallways");
  fields.number("min_length", p.min_length, {0.0, 100.0},
                "[m] where both sides stand; less takes deep doorways for hallways");
  fields.number("min_elongation", p.min_elongation, {0.0, 100.0},
                "length over width; less takes rooms for hallways");
  fields.number("max_gap", p.max_gap, {0.0, 100.0},
                "[m] a doorway in a side; more bridges side corridors");
  fields.number("max_offset", p.max_offset, {0.0, 10.0}, "[m] of a wall from the line of its side");
  fields.number("min_cover", p.min_cover, {0.0, 1.0},
                "of the length that must be wall, on each side");
  fields.number("reach", p.reach, {0.0, 1000.0},
                "[m] ahead and behind the robot; the centre line ends there");
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
  fields.group("entrance", config.entrance, "when a door is the way out");
  fields.group("hallway", config.hallway, "when the robot is in a hallway");
}

}  // namespace perceptor
