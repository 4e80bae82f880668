#include "components/merge/merge_component.hpp"

namespace perceptor {
namespace merge {
namespace {

constexpr config::Range kFraction{0.0, 1.0};
constexpr config::Range kSmall{1e-6, 1.0};  ///< standard deviations
constexpr config::Range kMetres{0.0, 10.0};
constexpr config::Range kAngle{0.0, 1.5};
constexpr config::Range kSigmas{0.1, 20.0};

}  // namespace

void describe(config::Fields& fields, SightingParameters& p) {
  fields.number("min_length", p.min_length, {1e-3, 10.0}, "[m] shorter walls are not taken in");
  fields.number("offset_sigma", p.offset_sigma, kSmall,
                "[m] added to the scan's own: what no scan knows of its mounting and timing");
  fields.number("angle_sigma", p.angle_sigma, kSmall, "[rad] the same of a wall's angle");
  fields.number("end_sigma", p.end_sigma, kSmall,
                "[m] the same of an end's place along its wall; known so well its weight is 1");
  fields.number("unknown_offset_sigma", p.unknown_offset_sigma, kSmall,
                "[m] of a wall that comes without covariance");
  fields.number("unknown_angle_sigma", p.unknown_angle_sigma, kSmall,
                "[rad] of a wall that comes without covariance");
  fields.number("unknown_end_sigma", p.unknown_end_sigma, kSmall,
                "[m] of an end that comes without covariance");
  fields.number("radius", p.radius, kMetres, "[m] of an end that comes without one");
  fields.number("max_radius", p.max_radius, kMetres, "[m] no end reaches further for a corner");
}

void describe(config::Fields& fields, SameWallParameters& p) {
  fields.number("offset", p.offset, kMetres, "[m] walls this close are one however sharp");
  fields.number("angle", p.angle, kAngle, "[rad] walls this parallel are one however sharp");
  fields.number("sigmas", p.sigmas, {0.0, 20.0},
                "standard deviations of both that are added to offset and angle");
  fields.number("max_offset", p.max_offset, kMetres, "[m] however uncertain they are");
  fields.number("max_angle", p.max_angle, kAngle, "[rad] however uncertain they are");
  fields.number("max_gap", p.max_gap, kMetres, "[m] pieces of wall further apart stay two");
  fields.number("shift", p.shift, kMetres,
                "[m] pieces seen in full that moved along by more are two");
}

void describe(config::Fields& fields, RegistrationParameters& p) {
  fields.group("odometry", p.odometry, "how much odometry errs");
  fields.choice(
      "landmarks", p.landmarks,
      {{"walls", Landmarks::walls}, {"corners", Landmarks::corners}, {"both", Landmarks::both}},
      "what of a scan is laid on the map; corners alone show how the robot moved by them");
  fields.group("same_wall", p.same_wall, "which walls may be laid on each other");
  fields.integer("rounds", p.rounds, {1, 10}, "of matching anew");
  fields.integer("iterations", p.iterations, {1, 50}, "of least squares in each round");
  fields.number("outlier_sigmas", p.outlier_sigmas, kSigmas, "a wall this far off counts half");
  fields.number("annealing", p.annealing, {1.0, 1e3}, "the round before doubts so many times less");
  fields.number("max_correction", p.max_correction, kMetres, "[m] a larger one is not believed");
  fields.number("max_heading_correction", p.max_heading_correction, kAngle,
                "[rad] a larger one is not believed");
  fields.number("min_agreement", p.min_agreement, kFraction,
                "share of the matched length that has to fit afterwards");
  fields.number("unobservable_sigma", p.unobservable_sigma, {1e-3, 10.0},
                "[m] odometry alone rules a direction in which the walls would leave more");
}

void describe(config::Fields& fields, EndParameters& p) {
  fields.number("min_sigma", p.min_sigma, kSmall,
                "[m] no end is known better; larger lets one bad scan move a corner");
  fields.number("min_radius", p.min_radius, kMetres, "[m] the radius of a well known end");
  fields.number("seen_reach", p.seen_reach, kMetres,
                "[m] from where beams passed the end to something farther, to its corner");
}

void describe(config::Fields& fields, FusionParameters& p) {
  fields.number("outlier_sigmas", p.outlier_sigmas, kSigmas, "a line further off counts for less");
  fields.number("min_offset_sigma", p.min_offset_sigma, kSmall,
                "[m] no line is known better; larger lets old walls follow, and drift");
  fields.number("min_angle_sigma", p.min_angle_sigma, kSmall, "[rad] the same of its angle");
  fields.group("ends", p.ends, "how well ends become known");
  fields.integer("overshoots", p.overshoots, {1, 1000},
                 "sightings beyond a known end before it moves");
  fields.number("max_weight", p.max_weight, {1.0, 1e6},
                "of a wall, in sightings; larger: slower to forget");
}

void describe(config::Fields& fields, CornerParameters& p) {
  fields.number("min_angle", p.min_angle, {0.01, 1.5},
                "[rad] below it two lines do not fix a corner: their ends do");
  fields.number("max_step", p.max_step, kMetres,
                "[m] nearly parallel walls further apart sideways do not form a corner");
  fields.number(
      "max_hole", p.max_hole, kMetres,
      "[m] nor do those whose ends are further apart: more closes what may be an opening");
  fields.number("keep_radius", p.keep_radius, kMetres,
                "[m] a corner whose walls part further comes undone");
}

void describe(config::Fields& fields, ConfirmationParameters& p) {
  fields.integer("sightings", p.sightings, {1, 1000},
                 "scans that must see a wall before it is published");
  fields.number("min_time", p.min_time, {0.0, 60.0},
                "[s] from the first to the last of them; larger is safer against what moves");
  fields.number("min_share", p.min_share, {0.0, 1.0},
                "[-] of the scans since the first that must see it");
  fields.number("tentative_time", p.tentative_time, {0.0, 1e6},
                "[s] a wall that is not confirmed and unseen for so long is removed");
}

void describe(config::Fields& fields, SeesThroughParameters& p) {
  fields.number("behind", p.behind, {0.01, 10.0}, "[m] rays must end this far behind the wall");
  fields.number("end_margin", p.end_margin, kMetres, "[m] rays this near a wall's end say nothing");
  fields.number("min_width", p.min_width, kMetres, "[m] of wall that is passed through at once");
  fields.number("min_distance", p.min_distance, {1e-3, 10.0}, "[m] of the laser from the line");
}

void describe(config::Fields& fields, RivalParameters& p) {
  fields.number(
      "max_distance", p.max_distance, kMetres,
      "[m] walls of one side that lie closer, one behind the other, cannot both be there");
  fields.number("max_angle", p.max_angle, kAngle, "[rad] between the two");
  fields.number("min_overlap", p.min_overlap, kMetres, "[m] along the wall");
  fields.number("min_thickness", p.min_thickness, kMetres,
                "[m] of what has a back: then the other one may stand behind it");
  fields.integer("min_beams", p.min_beams, {1, 1000}, "that ended on the one seen last, there");
}

void describe(config::Fields& fields, ForgettingParameters& p) {
  fields.group("sees_through", p.sees_through, "when beams pass through a wall");
  fields.group("rivals", p.rivals, "when another wall was seen in the place of a wall");
  fields.number("factor", p.factor, {0.0, 0.999},
                "of a wall's weight kept by each scan that sees through it");
  fields.number("min_weight", p.min_weight, {0.0, 1e6}, "below it what is seen through goes");
  fields.number("min_piece", p.min_piece, kMetres, "[m] what is left beside it stays if longer");
}

}  // namespace merge

void describe(config::Fields& fields, MergeConfig& config) {
  // 200 walls and the markers are just below the 60 000 bytes of one message.
  fields.integer("max_walls", config.merge.max_walls, {1, 200},
                 "kept; beyond it the longest unseen is forgotten");
  fields.integer("max_rejected_scans", config.merge.max_rejected_scans, {0, 1000},
                 "that do not fit the map, in a row; then odometry is believed");
  fields.number("safe_distance", config.safe_distance, {0.0, 10.0},
                "[m] of the safe-distance octagon from the robot's centre");
  fields.group("sighting", config.merge.sighting, "how the walls of a scan are taken in");
  fields.group("registration", config.merge.registration, "the correction of the robot's pose");
  fields.group("same_wall", config.merge.same_wall, "which walls are one");
  fields.group("fusion", config.merge.fusion, "how two sightings become one wall");
  fields.group("corners", config.merge.corners, "how ends of walls are connected");
  fields.group("confirmation", config.merge.confirmation, "what makes a wall certain");
  fields.group("forgetting", config.merge.forgetting, "what takes a wall out again");
  fields.group("robot", config.robot, "what belongs to the robot itself");
}

}  // namespace perceptor
