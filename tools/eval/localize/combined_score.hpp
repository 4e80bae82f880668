/// @file COMBINED_MAP against the simulated world: doors and things that the map does not have.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include "common/model/map.hpp"
#include "components/bridge/sim/simulator.hpp"
#include "tools/eval/localize/proportion.hpp"
#include "tools/eval/localize/trial.hpp"

namespace perceptor {

struct CombinedScoreParameters {
  double within = 3.0;         ///< [m] of the robot
  double door_after = 1.0;     ///< [s] in view, then its state has to be right
  double object_after = 3.0;   ///< [s] in view, then a thing has to be there
  double lapse = 0.5;          ///< [s] out of view, and the time in view begins anew
  double half_view = 1.9;      ///< [rad] to either side of the robot
  double min_incidence = 0.4;  ///< sine of the view onto a doorway
  int rays = 240;              ///< cast to see what is in view
  int object_rays = 8;         ///< on a thing in view
  double object_error = 0.35;  ///< [m] between the outlines of a thing and what was found of it
  double blocked = 0.35;       ///< [m] from a doorway to a thing that stands in it
  double person = 0.7;         ///< [m] a static thing this near is a person who stood there
  double stands_after = 1.5;   ///< [s] at one place
};

struct CombinedScore {
  Proportion doors;    ///< in view for a while, at each map: state right
  Proportion objects;  ///< the same: there at all
  int false_objects = 0;
  double time = 0.0;  ///< [s] of maps

  CombinedScore& operator+=(const CombinedScore& other);
};

class CombinedScorer {
 public:
  CombinedScorer(const sim::World& world, Doors doors, const CombinedScoreParameters& parameters)
      : world_(world), doors_are_(doors), parameters_(parameters) {}

  /// Doors and obstacles of one map, with the truth at its time [s].
  void take(const Map& map, const sim::Truth& truth, double time);

  const CombinedScore& score() const { return score_; }

 private:
  struct InView {
    double since = 0.0;
    double last = -1e9;
  };
  struct Stand {
    Vector2 place = Vector2::Zero();
    double since = 0.0;  ///< [s]
  };
  using Looks = std::map<std::size_t, InView>;

  double in_view_for(Looks& looks, std::size_t which, bool is_seen, double time) const;
  void note_people(const sim::Truth& truth, double time);
  bool is_blocked(const Segment& opening) const;
  void score_doors(const Map& map, const Position& robot, double time);
  void score_objects(const Map& map, const sim::Truth& truth, double time);
  std::vector<int> rays_on_boxes(const Position& robot) const;

  const sim::World& world_;
  Doors doors_are_;
  CombinedScoreParameters parameters_;
  CombinedScore score_;
  Looks doors_;
  Looks boxes_;
  std::vector<Stand> people_;  ///< since when each has been about where it is
  std::vector<Stand> stands_;  ///< where one stayed
  std::set<std::int32_t> false_ids_;
  double last_ = -1.0;
};

}  // namespace perceptor
