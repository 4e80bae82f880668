/// @file The ways out of the place the robot is in, as one map shows them.
///
/// A way out is an opening (openings.hpp)
/// - that is a door. An end of a possible door may be a wall that goes on unseen, and a false exit
///   is worse than a late one: that opening becomes a door once the robot has come nearer;
/// - of which both walls were seen lately: what is only remembered may have been shut;
/// - that the robot stands before, on the side from which the walls were seen;
/// - whose middle the robot sees: no wall crosses the straight line to it;
/// - that lies behind no other opening, because that one may lead out already.
#pragma once

#include <cstdint>
#include <vector>

#include "common/model/map.hpp"
#include "components/identify/walls.hpp"

namespace perceptor::identify {

/// When a door is the way out: what find_exits looks at, and what EntranceTracker asks of it.
struct EntranceParameters {
  double max_distance = 8.0;     ///< [m] from the robot to the middle; further is not looked at
  double max_unseen = 2.5;       ///< [s] since both walls were last seen; more trusts what may
                                 ///< have been shut behind the robot, less forgets while it turns
  int scans = 15;                ///< the last ones that are looked at; more is steadier and later
  double max_age = 1.5;          ///< [s] older ones are forgotten; a slow laser needs more
  double min_share = 0.6;        ///< [-] of `scans` that must agree; less is sooner, and wrong
                                 ///< sooner
  double min_confidence = 0.45;  ///< [-] of the median; less names doubtful openings
  double half_distance = 3.0;    ///< [m] at which a door is worth half; less prefers near ones
  double same_opening = 0.4;     ///< [m] between middles of sightings of one opening; more mixes
                                 ///< neighbouring doors
  double max_scatter = 0.1;      ///< [m] from the median, of middle and width, that still agrees
  double max_turn = 0.2;         ///< [rad] the same of the direction
  double switch_gain = 1.3;      ///< [-] times better that another one must be to take over
};

/// An opening that leads out, in any frame.
struct Exit {
  Vector2 middle = Vector2::Zero();  ///< [m]
  double direction = 0.0;            ///< [rad] outward, perpendicular to the opening
  double width = 0.0;                ///< [m]
  double confidence = 0.0;           ///< 0 to 1
};

/// An exit of frame b, seen from a.
Exit transform(const Position& b_in_a, const Exit& exit_in_b);

/// The ways out of an identified map, in the order of its openings. `walls`: read_walls(map).
/// `robot`: [m] in the map's frame. `utime`: [us] that of the map.
std::vector<Exit> find_exits(const Map& map, const std::vector<Wall>& walls, const Vector2& robot,
                             std::int64_t utime, const EntranceParameters& parameters = {});

}  // namespace perceptor::identify
