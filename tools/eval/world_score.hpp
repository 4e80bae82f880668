/// @file What was found, against what the simulator says is there.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include <pico/map_t.hpp>
#include <pico/truth_t.hpp>

#include "common/geometry/position.hpp"
#include "common/geometry/segment.hpp"
#include "tools/eval/on_a_wall.hpp"

namespace perceptor {

struct WorldScoreParameters {
  OnAWallParameters on_a_wall;
  double max_door_offset = 0.25;  ///< [m] between the middles of a found door and the true one
};

/// How far a pose is from the true one.
struct PoseError {
  double distance = 0.0;  ///< [m]
  double angle = 0.0;     ///< [rad], never negative
};

struct WorldScore {
  std::int64_t maps = 0;
  std::int64_t walls = 0;          ///< found, over all maps
  std::int64_t walls_right = 0;    ///< of those, lying on a wall of the world
  std::int64_t doors = 0;          ///< found, over all maps
  std::int64_t doors_right = 0;    ///< of those, in a door opening of the world
  std::size_t openings = 0;        ///< in the world, doors that never stood open not counted
  std::size_t openings_found = 0;  ///< of those, found at least once
  PoseError odometry_at_end;       ///< drift of robot_in_zero
  PoseError merge_at_end;          ///< drift of robot_in_local
  double driven = 0.0;             ///< [m]
};

class WorldScorer {
 public:
  explicit WorldScorer(const WorldScoreParameters& parameters = {}) : parameters_(parameters) {}

  void take(const pico::truth_t& truth);
  void take_world(const pico::map_t& message);
  void take_identified(const pico::map_t& map);

  std::optional<WorldScore> score() const;

 private:
  struct Opening {
    Segment segment;
    bool is_open = false;  ///< when the world was last told
    bool is_found = false;
  };

  void compare(const pico::truth_t& truth, const pico::map_t& message);
  Opening* opening_at(const Segment& found_in_world);

  WorldScoreParameters parameters_;
  WorldScore score_;
  std::vector<Segment> walls_;                ///< of the world
  std::map<std::int32_t, Opening> openings_;  ///< every door that ever stood open, by its id
  std::deque<pico::truth_t> truths_;          ///< the last ones
  std::deque<pico::map_t> early_;             ///< maps that stand before their truth in the log
  std::optional<Position> first_in_world_;    ///< where the session began
  std::int64_t session_ = 0;
};

}  // namespace perceptor
