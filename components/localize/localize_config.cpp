#include "common/config/robot.hpp"
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
  fields.integer("slid", p.slid, {0, 50}, "walls that are slid along the map's, the longest");
  fields.number("slide", p.slide, {0.01, 10.0}, "[m] from place to place");
  fields.integer("count", p.count, {1, 100000}, "kept: the best");
}

void describe(config::Fields& fields, AlignmentParameters& p) {
  fields.integer("iterations", p.iterations, {1, 50}, "of least squares");
  fields.number("max_offset", p.max_offset, kMetres, "[m] from a wall to that of the map");
  fields.number("max_angle", p.max_angle, kAngle, "[rad] the same");
  fields.number("max_shift", p.max_shift, kMetres, "[m] from a corner to that of the map");
  fields.number("min_overlap", p.min_overlap, kShare, "of the shorter of the two");
  fields.number("map_sigma", p.map_sigma, kSmall,
                "[m] how far the real walls stand off the map, at a guess");
  fields.number("outlier_sigmas", p.outlier_sigmas, {0.1, 20.0}, "a wall this far off counts half");
}

void describe(config::Fields& fields, BeamFitParameters& p) {
  fields.integer("beams", p.beams, {10, 10000}, "of a scan, evenly chosen");
  fields.number("sigma", p.sigma, kSmall,
                "[m] of a range: noise, and walls that stand off the map");
  fields.number("hit", p.hit, kShare, "share of the beams that end where the map says");
  fields.number("in_front", p.in_front, kShare, "share that end at something unknown before that");
  fields.number("anything", p.anything, {1e-6, 1.0}, "share that measure anything");
  fields.number("behind", p.behind, {1e-9, 1.0}, "share that measure anything behind a wall");
  fields.number("through", p.through, kMetres,
                "[m] a range longer than the map says by more goes through a wall");
  fields.number("max_range", p.max_range, {0.1, 1000.0}, "[m] of what measures anything");
}

void describe(config::Fields& fields, BeamAlignmentParameters& p) {
  fields.integer("iterations", p.iterations, {1, 50}, "of least squares");
  fields.number("reach", p.reach, kMetres, "[m] from the end of a beam to the wall that it is of");
  fields.number("min_cosine", p.min_cosine, kShare, "between a beam and that wall's normal");
  fields.number("map_sigma", p.map_sigma, kSmall, "[m] how far the real walls stand off the map");
  fields.number("outlier", p.outlier, kSmall, "[m] an end this far off counts half");
  fields.number("together", p.together, {1.0, 1000.0},
                "so many beams err in the same way: they count as one");
}

void describe(config::Fields& fields, SearchParameters& p) {
  fields.group("candidates", p.candidates, "where the robot could be, from walls alone");
  fields.group("alignment", p.alignment, "how these are laid on the map");
  fields.group("beams", p.beams, "how well a scan fits");
  fields.integer("glance_every", p.glance_every, {1, 1000}, "of the beams chooses candidates");
  fields.number("glance_sigma", p.glance_sigma, {1e-6, 1.0},
                "[m] of a range there, with a candidate's own error");
  fields.integer("glances", p.glances, {1, 10000}, "candidates that are looked at closer");
  fields.number("climb", p.climb, {1e-4, 1.0}, "[m] and [rad] first step uphill from there");
  fields.number("climb_end", p.climb_end, {1e-4, 1.0}, "[m] and [rad] least step");
  fields.number("view", p.view, {1e-3, 100.0},
                "[m] so far from all before a scan is evidence of its own");
  fields.number("view_angle", p.view_angle, {1e-3, 100.0}, "[rad] or after turning so far");
  fields.number("turned_views", p.turned_views, {0.0, 100.0},
                "turning around shows no more than so many");
  fields.number("view_exponent", p.view_exponent, kShare,
                "evidence of the views: 0 that of one, 1 that of each anew");
  fields.number("max_through", p.max_through, kShare,
                "share of the beams through walls: no place with more is in the running");
  fields.number("long_wall", p.long_wall, kMetres, "[m] boxes are rarely as long");
  fields.number("strange_wall", p.strange_wall, {0.0, 1e6},
                "log likelihood lost for each metre of a long wall that the map does not have");
  fields.integer("followed", p.followed, {0, 1000},
                 "best places whose way is laid on the map keyframe by keyframe, for maps that are "
                 "bent themselves; 0: the way is rigid");
  fields.group("beam_alignment", p.beam_alignment, "how beams are laid on the map");
  fields.group("bend", p.bend, "how much the way between keyframes may bend");
  fields.number("same_place", p.same_place, kMetres, "[m] hypotheses this close are one");
  fields.number("same_heading", p.same_heading, kAngle, "[rad] the same");
}

void describe(config::Fields& fields, KeyframeParameters& p) {
  fields.number("distance", p.distance, kMetres, "[m] from the last; closer ones say the same");
  fields.number("angle", p.angle, {0.0, 3.2}, "[rad] the same");
  fields.integer("count", p.count, {1, 1000}, "kept; more decide safer and cost more");
  fields.number("reach", p.reach, {0.1, 1e6},
                "[m] and [rad] of way, before which all is forgotten");
}

void describe(config::Fields& fields, ClaimParameters& p) {
  fields.integer("min_keyframes", p.min_keyframes, {1, 1000}, "that were seen from the place");
  fields.integer("min_leads", p.min_leads, {1, 1000}, "on which it beats the runner-up");
  fields.number("margin", p.margin, {0.0, 1e6}, "of log likelihood over the runner-up");
  fields.number("lost_margin", p.lost_margin, {0.0, 1e6},
                "another place this much better ends a claim");
  fields.number("min_explained", p.min_explained, kShare,
                "share of the beams that end where the map says");
  fields.integer("ambiguous_keyframes", p.ambiguous_keyframes, {1, 1000},
                 "after so many, places without a margin are called ambiguous");
}

void describe(config::Fields& fields, WatchParameters& p) {
  fields.number("min_explained", p.min_explained, kShare,
                "a scan that fits less speaks against the pose");
  fields.number("max_through", p.max_through, kShare, "or one with more beams through walls");
  fields.number("poor_explained", p.poor_explained, kShare,
                "or one that is poor in both: fits less than this");
  fields.number("poor_through", p.poor_through, kShare, "and has more than this through walls");
  fields.number("time", p.time, {0.0, 60.0}, "[s] of such scans: lost");
  fields.number("period", p.period, {0.1, 3600.0}, "[s] until the claimed place has to win again");
}

void describe(config::Fields& fields, UnknownObjectParameters& p) {
  constexpr config::Range kBeams{0.0, 1e6};
  constexpr config::Range kSeconds{0.0, 3600.0};
  fields.number("cell", p.cell, {0.01, 1.0}, "[m] in which ends of beams are counted");
  fields.number("hit", p.hit, kBeams, "what a beam that ends in a cell counts");
  fields.number("pass", p.pass, kBeams, "what one that passes through counts against it");
  fields.number("most", p.most, kBeams, "a cell's count is no larger");
  fields.number("least", p.least, kBeams, "of a cell of a static object");
  fields.number("min_age", p.min_age, kSeconds, "[s] that such a cell was hit");
  fields.integer("few", p.few, {0, 1000}, "a thing of no more cells may be a person");
  fields.number("few_age", p.few_age, kSeconds, "[s] that one of its cells has to be hit instead");
  fields.number("pause", p.pause, kSeconds, "[s] without a beam, and that time begins anew");
  fields.number("object", p.object, kBeams, "least count of a static object, over its cells");
  fields.number("moving", p.moving, kBeams, "the same of a dynamic one");
  fields.number("fresh", p.fresh, kSeconds, "[s] since a dynamic one was hit");
  fields.number("behind", p.behind, {0.0, 10.0}, "[m] behind a cell a beam ends that passed it");
  fields.number("touching", p.touching, {0.0, 10.0}, "[m] cells this close are of one object");
  fields.integer("max_cells", p.max_cells, {10, 1'000'000}, "then the weakest go");
}

void describe(config::Fields& fields, CombinedMapParameters& p) {
  fields.integer("beams", p.beams, {10, 10000}, "of a scan, evenly chosen");
  fields.number("max_sigma", p.max_sigma, kSmall,
                "[m] of the pose; less certain, and the scan does not count");
  fields.number("max_angle", p.max_angle, kSmall, "[rad] the same");
  fields.number("check_period", p.check_period, {0.0, 3600.0},
                "[s] until the pose has to fit better than those beside it again");
  fields.number("beside", p.beside, kMetres, "[m] how far beside");
  fields.number("askew", p.askew, kAngle, "[rad] and twice that, the same");
  fields.number("tolerance", p.tolerance, kMetres, "[m] a beam this close to a wall ends on it");
  fields.number("through", p.through, kMetres, "[m] one so far behind it passes through");
  fields.number("wall", p.wall, {0.0, 1e6}, "beams in balance confirm or contradict a wall");
  fields.number("most_wall", p.most_wall, {0.0, 1e6}, "the balance goes no further");
  fields.number("door_middle", p.door_middle, kShare, "share of a doorway's width that tells");
  fields.number("min_incidence", p.min_incidence, kShare, "sine of a beam's angle to walls, doors");
  fields.number("leaf", p.leaf, kMetres, "[m] from a wall's faces: where a leaf may stand");
  fields.number("door_memory", p.door_memory, {0.01, 3600.0},
                "[s] in which what was seen of a doorway fades");
  fields.number("door", p.door, {0.0, 1e6}, "beams that tell its state");
  fields.number("max_range", p.max_range, {0.0, 1000.0},
                "[m] unknown things farther away are not looked at");
  fields.group("objects", p.objects, "things that the map does not have");
}

}  // namespace localize

void describe(config::Fields& fields, LocalizeConfig::StartConfig& start) {
  using Start = LocalizeConfig::Start;
  fields.choice(
      "from", start.from,
      {{"anywhere", Start::anywhere}, {"start_area", Start::start_area}, {"pose", Start::pose}},
      "what is known of where the robot starts; start_area: the map's");
  fields.group("pose", start.pose, "[m, rad] in the world");
  fields.number("distance", start.distance, {0.0, 100.0},
                "[m] from that pose, or outside the start area");
  fields.number("angle", start.angle, {0.0, 3.2}, "[rad] from that pose");
}

void describe(config::Fields& fields, LocalizeConfig& config) {
  localize::LocalizerParameters& p = config.localize;
  fields.text("map", config.map, "the building: a name in the folder maps, or a JSON file");
  fields.group("start", config.start, "a hint; after the robot was lost it may be anywhere");
  fields.group("search", p.search, "all places of the building compete");
  fields.group("keyframes", p.keyframes, "the scans that they compete for");
  fields.group("claim", p.claim, "what makes a place certain");
  fields.choice(
      "track_by", p.track_by,
      {{"walls", localize::TrackBy::walls}, {"beams", localize::TrackBy::beams}},
      "of each scan; beams, laid on the map as in search, where its walls are off by decimetres");
  fields.group("tracking", p.tracking, "how the robot is followed by walls");
  fields.group("motion", p.motion, "how much the local map's own pose errs");
  fields.group("watch", p.watch, "what takes a claim back");
  fields.number("map_time", p.map_time, {0.01, 3600.0},
                "[s] in which is learnt how far the walls stand off the map");
  fields.number("min_map_sigma", p.min_map_sigma, {1e-6, 1.0}, "[m] they do at least");
  fields.number("walls_together", p.walls_together, {1.0, 100.0},
                "so many neighbours stand off it in the same way: their error counts as one");
  fields.number("search_time", p.search_time, {0.0, 10.0},
                "[s] from the scan that asks to the first that may know; scans wait if a search "
                "takes longer");
  fields.number("found_sigma", p.found_sigma, {1e-6, 1.0}, "[m] of the pose when it is claimed");
  fields.number("found_heading_sigma", p.found_heading_sigma, {1e-6, 1.0}, "[rad] the same");
  fields.group("combined", config.combined, "what the robot found of the building");
  fields.number("combined_period", config.combined_period, {0.0, 60.0},
                "[s] of scans from one COMBINED_MAP to the next");
}

}  // namespace perceptor
