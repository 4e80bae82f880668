/// @file LOCAL_MAP and IDENTIFIED_MAP of a log against the simulator's truth.
///
/// Of each session, the maps of the first seconds left out, one map each half second is scored.
/// It is laid into the world by the robot's true pose at its utime, so that an error of merge's
/// own pose is none of the map.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <pico/map_t.hpp>
#include <pico/truth_t.hpp>

#include "common/log/event_log.hpp"
#include "tools/eval/corner_score.hpp"
#include "tools/eval/door_score.hpp"
#include "tools/eval/double_walls.hpp"
#include "tools/eval/on_a_wall.hpp"
#include "tools/eval/seen_sides.hpp"
#include "tools/eval/wall_recall.hpp"
#include "tools/eval/world_view.hpp"

namespace perceptor {

struct MapScoreParameters {
  double skipped = 2.0;        ///< [s] from the session's first scan: the map begins to form
  double period = 0.5;         ///< [s] from one scored map to the next
  double max_reach = 8.0;      ///< [m] what the laser hits farther away is not asked for
  double max_beam_gap = 0.15;  ///< [m] along a wall between two beams: what lies between is seen
  SeenParameters seen;
  WallRecallParameters recall;
  OnAWallParameters on_a_wall;
  DoubleWallParameters doubles = {.max_age = 1e9, .max_distance = 0.15, .min_overlap = 0.2};
  CornerScoreParameters corners;
  DoorScoreParameters doors;
  TrueWorldParameters world;
};

struct MapScore {
  std::int64_t maps = 0;     ///< local maps that were scored
  Share walls;               ///< recall: walls of the world seen so far that the map holds
  Share furniture;           ///< the same of the sides of cabinets and boxes
  Share right;               ///< precision: walls of the map that lie on one of the world
  std::int64_t doubles = 0;  ///< pairs of walls of the map that stand for one
  CornerScore corners;
  DoorScore doors;
};

class MapScorer {
 public:
  /// For people: one line for each thing that is wrong with a scored map.
  using Sink = std::function<void(const std::string&)>;

  explicit MapScorer(const MapScoreParameters& parameters = {}, Sink sink = {});

  /// Channels that tell nothing of maps are passed over, and what cannot be decoded.
  void take(const LogEvent& event);

  /// With no maps where the log holds no truth, or no maps.
  MapScore score() const;

 private:
  struct Pose {
    std::int64_t session;
    std::int64_t seq;
    Position robot_in_world;
  };
  struct Waiting {
    pico::map_t map;
    bool is_identified;
  };

  void take_world(const pico::map_t& part);
  void take_truth(const pico::truth_t& truth);
  void take_map(const pico::map_t& map, bool is_identified);
  void begin_session(const pico::truth_t& truth);
  bool is_due(std::int64_t utime, std::int64_t& next) const;
  void score_local(const pico::map_t& message, const Position& robot_in_world);
  void score_identified(const pico::map_t& message, const Position& robot_in_world);
  void tell(std::int64_t utime, const char* what, const Segment& where, const std::string& more);

  MapScoreParameters parameters_;
  Sink sink_;
  MapScore score_;
  DoorScorer doors_;
  SeenSides seen_;
  std::optional<BeamFan> fan_;
  Position laser_in_robot_;
  Map world_parts_;  ///< of a SIM_WORLD that is not complete yet
  TrueWorld world_;
  std::deque<Pose> poses_;     ///< the last ones
  std::deque<Waiting> early_;  ///< maps that stand before their truth in the log
  std::int64_t session_ = 0;
  std::int64_t first_utime_ = 0;  ///< 0: no truth yet
  std::int64_t next_local_ = 0;   ///< [us]
  std::int64_t next_identified_ = 0;
};

}  // namespace perceptor
