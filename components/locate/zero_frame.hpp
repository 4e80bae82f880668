/// @file The zero frame: the robot's pose at the first odometry of the session, and where the
/// robot is in it, as far as its wheels can tell.
#pragma once

#include <cstdint>
#include <optional>

#include "common/geometry/position.hpp"

namespace perceptor {

/// What no robot can drive from one odometry to the next. The defaults are wide on purpose:
/// recorded odometry has stamps a few milliseconds apart for a whole step (0.31 m in 4 ms), or
/// stands still while the robot drives and catches up in one step (0.95 m, or 1.5 rad, in
/// 0.21 s). A robot with good stamps is better guarded with its own limits and a small slack.
struct ZeroFrameParameters {
  double max_speed = 4.0;        ///< [m/s] more lets larger jumps pass as motion
  double distance_slack = 0.35;  ///< [m] more lets larger jumps pass, however short the time
  double max_turn_rate = 6.0;    ///< [rad/s] more lets larger jumps of the heading pass
  double heading_slack = 0.5;    ///< [rad] as distance_slack, for the heading
  double origin_radius = 0.05;   ///< [m] a jump that ends this near to the odometry's origin
                                 ///< is a robot that was switched on anew
  double origin_heading = 0.05;  ///< [rad] and with a heading this near to zero
};

/// How an odometry follows the one before it.
enum class OdometryStep {
  first,            ///< there is none before it: its pose becomes the zero position
  driven,           ///< a robot can have driven it
  jumped,           ///< no robot can have driven it
  switched_on_anew  ///< it fell back to the origin of the odometry
};

/// Whether a robot can have driven from one odometry to the next in `seconds` (less than zero
/// counts as zero). A long way to the very origin is taken for a robot that was switched on
/// anew however much time went by, because switching on takes time in which much could have
/// been driven; short of the slacks it is taken for driving.
OdometryStep classify_step(const Position& from_in_odometry, const Position& to_in_odometry,
                           double seconds, const ZeroFrameParameters& parameters);

/// Where the robot is, after one odometry.
struct ZeroPosition {
  std::int64_t zero_utime = 0;  ///< [us] utime of the first odometry; names the zero frame
  Position zero_in_odometry;    ///< the first odometry, moved along with each bridged jump
  Position robot_in_zero;
  int bridged = 0;  ///< jumps since the first odometry
  OdometryStep step = OdometryStep::first;
};

/// Follows the odometry of one robot.
///
/// A jump is bridged by holding the pose: the robot is where it was before, and the zero frame
/// moves along in the odometry frame. The alternative, to go on with the last velocity, would
/// invent motion: a robot that was lifted, stuck or switched off stood still, and after one
/// bad reading the last velocity is itself the bad one. What holding loses is the motion of
/// that one step; a single bad reading costs two steps, there and back.
class ZeroFrame {
 public:
  explicit ZeroFrame(const ZeroFrameParameters& parameters = {}) : parameters_(parameters) {}

  /// Takes the next odometry. `began_anew`: another session, so its pose becomes zero.
  ZeroPosition update(std::int64_t utime, const Position& robot_in_odometry, bool began_anew);

 private:
  struct Last {
    std::int64_t utime = 0;
    Position robot_in_odometry;
    ZeroPosition position;
  };

  ZeroFrameParameters parameters_;
  std::optional<Last> last_;
};

}  // namespace perceptor
