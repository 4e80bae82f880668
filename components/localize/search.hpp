/// @file All places of the building compete for what the robot saw from its last poses.
#pragma once

#include <functional>
#include <vector>

#include "components/localize/alignment.hpp"
#include "components/localize/beam_alignment.hpp"
#include "components/localize/beam_fit.hpp"
#include "components/localize/candidates.hpp"

namespace perceptor::localize {

/// A scan that is kept, taken from another pose than its neighbours.
struct Keyframe {
  Position robot_in_local;
  std::vector<Beam> beams;
  double way = 0.0;  ///< [m] and [rad] from the first one
};

struct SearchParameters {
  CandidateParameters candidates;
  AlignmentParameters alignment;
  BeamFitParameters beams;
  int glance_every = 3;         ///< of the beams: to choose among candidates
  double glance_sigma = 0.12;   ///< [m] of a range, with a candidate's own error
  int glances = 150;            ///< candidates that are looked at closer
  double climb = 0.1;           ///< [m] and [rad] first step uphill from these, then its halves
  double climb_end = 0.01;      ///< [m] and [rad] the least step
  double view = 0.5;            ///< [m] so far from all before a scan is evidence of its own
  double view_angle = 2.0;      ///< [rad] or after turning so far
  double turned_views = 2.0;    ///< turning around shows no more than so many
  double view_exponent = 0.75;  ///< of the views: 0 if all were wrong in the same way, 1 if each
                                ///< were wrong in its own
  double max_through = 0.15;    ///< share of the beams through walls; a place with more is out
  double long_wall = 0.8;       ///< [m] boxes are rarely as long
  double strange_wall = 10.0;   ///< log likelihood lost for each metre of a long wall that the map
                                ///< does not have
  int followed = 0;             ///< best places whose way is laid on the map keyframe by keyframe,
                                ///< for maps that are bent themselves; 0: the way is rigid
  BeamAlignmentParameters beam_alignment;  ///< how a scan's beams are laid on the map
  MotionNoise bend{.translation = 0.05,
                   .heading = 0.03,
                   .heading_by_translation = 0.03,
                   .still = 0.01};  ///< of the way from one to the next, as if each took a second
  double same_place = 0.4;          ///< [m] hypotheses this close are one
  double same_heading = 0.3;        ///< [rad] the same
};

/// A place that explains what the robot saw.
struct Hypothesis {
  Position local_in_world;
  double log_likelihood = 0.0;      ///< mean of the keyframes, less what strange walls cost, times
                                    ///< the evidence of the views
  std::vector<double> by_keyframe;  ///< of each
  double explained = 0.0;           ///< share of the beams, mean over the keyframes
  double through = 0.0;             ///< share that go through walls
};

/// What was seen, and what is known of where.
struct Question {
  std::vector<LocalWall> walls;     ///< local frame
  std::vector<Keyframe> keyframes;  ///< at least one
  std::vector<Position> known;      ///< poses of the local frame in the world: they compete too
  std::function<bool(const Position& local_in_world)> is_possible;  ///< none: every place is
};

/// How well a place explains what was seen.
Hypothesis judge(const World& world, const Position& local_in_world, const Question& question,
                 const SearchParameters& parameters);

/// The same with the way bent to the map, backward from the last keyframe: `local_in_world` comes
/// out as it is there.
Hypothesis follow(const World& world, const Position& local_in_world, const Question& question,
                  const SearchParameters& parameters);

/// Best first, no two at one place.
std::vector<Hypothesis> search(const World& world, const Question& question,
                               const SearchParameters& parameters);

/// How many scans' worth of evidence the keyframes are: what was seen from nearly one pose is wrong
/// in the same way each time. Who comes back to where it was sees nothing new.
double views(const std::vector<Keyframe>& keyframes, const SearchParameters& parameters);

bool is_same_place(const Position& p, const Position& q, const SearchParameters& parameters);

}  // namespace perceptor::localize
