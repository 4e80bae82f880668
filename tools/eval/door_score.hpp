/// @file Doors of maps against the true openings: right ones, missed ones, and how long it takes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "tools/eval/explained_beams.hpp"
#include "tools/eval/seen_sides.hpp"
#include "tools/eval/true_world.hpp"
#include "tools/eval/world_view.hpp"

namespace perceptor {

struct DoorScoreParameters {
  double min_width = 0.5;         ///< [m] narrower openings count neither way
  double max_width = 1.5;         ///< [m] nor wider ones
  double from_furniture = 0.3;    ///< [m] nor those with a jamb so near to a cabinet or a box
  double reach = 3.0;             ///< [m] from the robot: openings and doors farther away neither
  double max_offset = 0.15;       ///< [m] between the middles of a door and its opening
  double max_width_error = 0.10;  ///< [m]
  double jamb_reach = 0.1;        ///< [m] a wall seen so near to its end shows the jamb
  double min_time = 1.0;          ///< [s] in reach, once seen: openings with less are not missed
  SeenParameters wall;            ///< what one scan has to show of the wall beside a jamb
};

struct DoorScore {
  Share right;                 ///< of the doors published
  Share standing;              ///< of the openings that have to be published, over the maps
  Share found;                 ///< of the openings that have to be, published at least once
  std::vector<double> delays;  ///< [s] of those found later than the scan that first showed all of
                               ///< it: from then on
};

class DoorScorer {
 public:
  explicit DoorScorer(const DoorScoreParameters& parameters) : parameters_(parameters) {}

  /// Each scan: what it shows, and where the robot is.
  void take_view(std::int64_t utime, const TrueWorld& world, const std::vector<SideView>& views,
                 const Vector2& robot_in_world);

  /// Each map: its doors in the world frame. Only some of the maps are counted in shares over
  /// maps, all of them in what is found, and when. Gives the openings that are missing.
  std::vector<const TrueOpening*> take_doors(std::int64_t utime, const TrueWorld& world,
                                             const std::vector<Segment>& doors,
                                             const Vector2& robot_in_world, bool is_counted);

  /// Of one door [world frame]: right, wrong, or none where it counts neither way.
  std::optional<bool> is_right(const TrueWorld& world, const Segment& door,
                               const Vector2& robot_in_world) const;

  /// A new session: what was seen is no longer so, what was counted stays.
  void begin_anew();

  DoorScore score() const;

 private:
  struct Seen {
    std::int64_t since = 0;          ///< [us] of the first scan that showed all of it; 0: none
    std::int64_t found = 0;          ///< [us] when it was first published; 0: never
    std::int64_t last_in_reach = 0;  ///< [us]
    double time_in_reach = 0.0;      ///< [s] since it was seen
  };

  bool counts(const TrueOpening& opening) const;
  bool is_in_reach(const TrueOpening& opening, const Vector2& robot_in_world) const;
  bool shows(const std::vector<SideView>& views, const TrueWorld& world,
             const OpeningFace& face) const;
  bool matches(const TrueOpening& opening, const Segment& door) const;
  void add(const Seen& seen, DoorScore& score) const;

  DoorScoreParameters parameters_;
  DoorScore score_;
  std::map<std::int32_t, Seen> seen_;  ///< by the opening's id
};

}  // namespace perceptor
