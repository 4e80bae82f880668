#include "components/viewer/frames.hpp"

#include <algorithm>

namespace perceptor::viewer {
namespace {

constexpr std::size_t kRememberedPoses = 200;  // some seconds of scans

}  // namespace

void Frames::take_zero_pose(std::int64_t utime, const Position& robot_in_zero) {
  robot_in_zero_ = {utime, robot_in_zero};
}

void Frames::take_local_pose(std::int64_t utime, const Position& robot_in_zero,
                             const Position& robot_in_local) {
  zero_in_local_ = compose(robot_in_local, inverse(robot_in_zero));
  local_poses_.push_back({utime, robot_in_local});
  if (local_poses_.size() > kRememberedPoses) local_poses_.pop_front();
  lay_world();
  lay_true_world();
}

void Frames::take_world_pose(std::int64_t utime, const std::optional<Position>& robot_in_world) {
  world_pose_.reset();
  if (robot_in_world)
    world_pose_ = {utime, *robot_in_world};
  else
    world_in_local_.reset();
  lay_world();
}

void Frames::take_true_pose(std::int64_t utime, const Position& robot_in_world) {
  if (true_world_in_local_) return;
  true_pose_ = {utime, robot_in_world};
  lay_true_world();
}

void Frames::lay_world() {
  if (!world_pose_) return;
  if (const auto robot = robot_in_local(world_pose_->utime))
    world_in_local_ = compose(*robot, inverse(world_pose_->robot));
}

void Frames::lay_true_world() {
  if (true_world_in_local_ || !true_pose_) return;
  if (const auto robot = robot_in_local(true_pose_->utime))
    true_world_in_local_ = compose(*robot, inverse(true_pose_->robot));
}

std::optional<Position> Frames::robot_in_local(std::int64_t utime) const {
  const auto pose = std::ranges::find(local_poses_, utime, &Pose::utime);
  if (pose == local_poses_.end()) return std::nullopt;
  return pose->robot;
}

std::optional<Position> Frames::robot_in_local() const {
  const bool is_odometry_newer =
      robot_in_zero_ &&
      (local_poses_.empty() || robot_in_zero_->utime >= local_poses_.back().utime);
  if (is_odometry_newer) return compose(zero_in_local_, robot_in_zero_->robot);
  if (!local_poses_.empty()) return local_poses_.back().robot;
  return std::nullopt;
}

SceneFrame Frames::frame() const {
  if (world_in_local_) return SceneFrame::world;
  return robot_in_local() ? SceneFrame::local : SceneFrame::robot;
}

Position Frames::local_in_scene() const {
  return world_in_local_ ? inverse(*world_in_local_) : Position{};
}

Position Frames::robot_in_scene() const {
  return compose(local_in_scene(), robot_in_local().value_or(Position{}));
}

Position Frames::robot_in_scene(std::int64_t utime) const {
  const auto robot = robot_in_local(utime);
  return robot ? compose(local_in_scene(), *robot) : robot_in_scene();
}

std::optional<Position> Frames::world_in_scene() const {
  if (world_in_local_ || !robot_in_local()) return Position{};
  return std::nullopt;
}

std::optional<Position> Frames::true_world_in_scene() const {
  if (world_in_local_ || !robot_in_local()) return Position{};
  return true_world_in_local_;
}

}  // namespace perceptor::viewer
