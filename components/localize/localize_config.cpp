#include "components/localize/localize_component.hpp"

namespace perceptor {
namespace localize {
namespace {

constexpr config::Range kMetres{0.0, 10.0};
constexpr config::Range kAngle{0.0, 1.5};
constexpr config::Range kShare{0.0, 1.0};
constexpr config::Range kSmall{1e-6, 1.0};  ///< standard deviations

}  // namespace

void describe(config::Fields& fields, CandidateParameters& p) {
  fields.integer("walls", p.walls, {2, 50}, "the longest, of which each two are tried");
  fields.number("min_angle", p.min_angle, {0.01, 1.5},
                "[rad] two walls closer to parallel do not fix a pose");
  fields.number("max_angle", p.max_angle, kAngle, "[rad] between a wall and what it is laid on");
  fields.number("max_offset", p.max_offset, kMetres, "[m] the same");
  fields.number("min_share", p.min_share, kShare, "of a wall that has to lie on the map's");
  fields.number("cell", p.cell, {0.01, 10.0}, "[m] candidates this close are one");
  fields.number("cell_angle", p.cell_angle, {0.01, 1.5}, "[rad] the same");
  fields.integer("count", p.count, {1, 10000}, "kept: the best");
}

void describe(config::Fields& fields, AlignmentParameters& p) {
  fields.integer("iterations", p.iterations, {1, 50}, "of least squares");
  fields.number("max_offset", p.max_offset, kMetres, "[m] from a wall to that of the map");
  fields.number("max_angle", p.max_angle, kAngle, "[rad] the same");
  fields.number("max_shift", p.max_shift, kMetres, "[m] from a corner to that of the map");
  fields.number("min_overlap", p.min_overlap, kShare, "of the shorter of the two");
  fields.number("map_sigma", p.map_sigma, kSmall, "[m] how far the real walls stand off the map");
  fields.number("outlier_sigmas", p.outlier_sigmas, {0.1, 20.0}, "a wall this far off counts half");
}

void describe(config::Fields& fields, BeamFitParameters& p) {
  fields.integer("beams", p.beams, {10, 10000}, "of a scan, evenly chosen");
  fields.number("sigma", p.sigma, kSmall,
                "[m] of a range: noise, and walls that stand off the map");
  fields.number("hit", p.hit, kShare, "share of the beams that end where the map says");
  fields.number("in_front", p.in_front, kShare, "share that end at something unknown before that");
  fields.number("anything", p.anything, {1e-6, 1.0}, "share that measure anything");
  fields.number("shut", p.shut, kShare, "how often a door is shut");
  fields.number("through", p.through, kMetres,
                "[m] a range longer than the map says by more goes through a wall");
  fields.number("max_range", p.max_range, {0.1, 1000.0}, "[m] of what measures anything");
}

void describe(config::Fields& fields, SearchParameters& p) {
  fields.group("candidates", p.candidates, "where the robot could be, from walls alone");
  fields.group("alignment", p.alignment, "how these are laid on the map");
  fields.group("beams", p.beams, "how well a scan fits");
  fields.integer("glance_every", p.glance_every, {1, 1000}, "of the beams chooses candidates");
  fields.number("glance_sigma", p.glance_sigma, {1e-6, 1.0},
                "[m] of a range there, with a candidate's own error");
  fields.integer("glances", p.glances, {1, 10000}, "candidates that are looked at closer");
  fields.number("view", p.view, {1e-3, 100.0},
                "[m] after moving so far a scan is evidence of its own");
  fields.number("view_angle", p.view_angle, {1e-3, 100.0}, "[rad] or after turning so far");
  fields.number("max_through", p.max_through, kShare,
                "share of the beams through walls: no place with more is in the running");
  fields.number("same_place", p.same_place, kMetres, "[m] hypotheses this close are one");
  fields.number("same_heading", p.same_heading, kAngle, "[rad] the same");
}

void describe(config::Fields& fields, KeyframeParameters& p) {
  fields.number("distance", p.distance, kMetres, "[m] from the last; closer ones say the same");
  fields.number("angle", p.angle, {0.0, 3.2}, "[rad] the same");
  fields.integer("count", p.count, {1, 1000}, "kept; more decide safer and cost more");
}

void describe(config::Fields& fields, ClaimParameters& p) {
  fields.integer("min_keyframes", p.min_keyframes, {1, 1000}, "that were seen from the place");
  fields.integer("min_leads", p.min_leads, {1, 1000}, "on which it beats the runner-up");
  fields.number("margin", p.margin, {0.0, 1e6}, "of log likelihood over the runner-up");
  fields.number("min_explained", p.min_explained, kShare,
                "share of the beams that end where the map says");
  fields.integer("ambiguous_keyframes", p.ambiguous_keyframes, {1, 1000},
                 "after so many, places without a margin are called ambiguous");
}

void describe(config::Fields& fields, WatchParameters& p) {
  fields.number("min_explained", p.min_explained, kShare,
                "a scan that fits less speaks against the pose");
  fields.number("max_through", p.max_through, kShare, "or one with more beams through walls");
  fields.number("time", p.time, {0.0, 60.0}, "[s] of such scans: lost");
  fields.number("period", p.period, {0.1, 3600.0}, "[s] until the claimed place has to win again");
}

}  // namespace localize

void describe(config::Fields& fields, LocalizeConfig& config) {
  localize::LocalizerParameters& p = config.localize;
  fields.text("map", config.map, "the building: a name in the folder maps, or a JSON file");
  fields.group("search", p.search, "all places of the building compete");
  fields.group("keyframes", p.keyframes, "the scans that they compete for");
  fields.group("claim", p.claim, "what makes a place certain");
  fields.group("tracking", p.tracking, "how the robot is followed");
  fields.group("motion", p.motion, "how much the local map's own pose errs");
  fields.group("watch", p.watch, "what takes a claim back");
  fields.number("search_time", p.search_time, {0.0, 10.0},
                "[s] from the scan that asks to the first that may know; scans wait if a search "
                "takes longer");
  fields.number("found_sigma", p.found_sigma, {1e-6, 1.0}, "[m] of the pose when it is claimed");
  fields.number("found_heading_sigma", p.found_heading_sigma, {1e-6, 1.0}, "[rad] the same");
}

}  // namespace perceptor
