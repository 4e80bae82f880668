/// @file Which frame a picture stands still in, and where the others lie in it: the world where the
/// robot is found in it, else the local frame, else the robot's own.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>

#include "components/viewer/scene.hpp"

namespace perceptor::viewer {

class Frames {
 public:
  /// From odometry. Until a local pose comes, zero and local are one.
  void take_zero_pose(std::int64_t utime, const Position& robot_in_zero);

  /// Of one scan, by odometry and with its drift taken out.
  void take_local_pose(std::int64_t utime, const Position& robot_in_zero,
                       const Position& robot_in_local);

  /// Where the same scan was taken in the building; none: not known.
  void take_world_pose(std::int64_t utime, const std::optional<Position>& robot_in_world);

  /// Where it was in truth.
  void take_true_pose(std::int64_t utime, const Position& robot_in_world);

  SceneFrame frame() const;

  /// Now; none: no pose has come yet.
  std::optional<Position> robot_in_local() const;

  /// Now; before the first pose, and in its own frame, where it is.
  Position robot_in_scene() const;
  /// When a scan was taken; where that is not known, now.
  Position robot_in_scene(std::int64_t utime) const;
  Position local_in_scene() const;

  /// None: not known. Where nothing is known of the robot at all, the world is the scene.
  std::optional<Position> world_in_scene() const;

  /// The same for the true world. Where the robot is not found in the world by itself, both worlds
  /// are laid on one another at the robot's first true pose.
  std::optional<Position> true_world_in_scene() const;

 private:
  struct Pose {
    std::int64_t utime;
    Position robot;
  };

  std::optional<Position> robot_in_local(std::int64_t utime) const;
  void lay_world();
  void lay_true_world();

  std::optional<Pose> robot_in_zero_;
  Position zero_in_local_;
  std::deque<Pose> local_poses_;                 ///< of the last scans, the newest last
  std::optional<Pose> world_pose_;               ///< the newest
  std::optional<Position> world_in_local_;       ///< by the newest scan that has both poses
  std::optional<Pose> true_pose_;                ///< the newest, until the true world is laid
  std::optional<Position> true_world_in_local_;  ///< by the first scan that has both poses
};

}  // namespace perceptor::viewer
