#include "components/merge/merger.hpp"

#include <algorithm>
#include <numbers>

#include "common/time/stamp.hpp"
#include "components/merge/association.hpp"
#include "components/merge/local_map.hpp"

namespace perceptor::merge {
namespace {

std::vector<Line> lines_of(const std::vector<Wall>& walls) {
  std::vector<Line> lines;
  lines.reserve(walls.size());
  for (const Wall& wall : walls) lines.push_back(line_of(wall.segment));
  return lines;
}

std::vector<Wall> in_local_frame(const std::vector<Wall>& sighted,
                                 const PoseEstimate& robot_in_local) {
  std::vector<Wall> walls;
  walls.reserve(sighted.size());
  for (const Wall& wall : sighted)
    walls.push_back(transform(robot_in_local.pose, robot_in_local.covariance, wall));
  return walls;
}

/// A line's direction has no sign: in (-pi/2, pi/2].
double undirected_angle(const Vector2& along) {
  const double a = angle(along);
  if (a > std::numbers::pi / 2.0) return a - std::numbers::pi;
  return a <= -std::numbers::pi / 2.0 ? a + std::numbers::pi : a;
}

/// Beams of this scan pass between two pieces of wall: a doorway, not a wall split in two.
bool is_doorway_between(const Line& p, const Line& q, const std::vector<Wall>& sighted,
                        const Vector2& laser, const SeesThroughParameters& parameters) {
  const std::optional<Segment> gap = gap_between(p, q);
  return gap && widest_opening(*gap, laser, sighted, parameters);
}

/// Corners of a wall that was merged are corners of the wall that it became part of, and what was
/// seen of it is.
void rename(std::vector<Wall>& walls, std::vector<Observation>& seen, std::int32_t from,
            std::int32_t to) {
  for (Wall& wall : walls)
    for (WallEnd& end : wall.ends)
      if (end.connected == from) end.connected = to;
  for (Observation& observation : seen)
    if (observation.wall == from) observation.wall = to;
}

}  // namespace

void Merger::clear() {
  walls_.clear();
  next_id_ = 0;
  rejected_in_a_row_ = 0;
  previous_.reset();
}

LocalMap Merger::update(const ScanMap& scan) {
  const std::vector<Wall> sighted =
      sighted_walls(scan.walls, scan.laser_in_robot.location(), scan.utime, parameters_.sighting);
  for (Wall& wall : walls_) wall.is_new = false;

  const PoseEstimate predicted = predict_pose(scan);
  const Registration registration =
      register_walls(sighted, walls_, lines_of(walls_), predicted, scan.laser_in_robot.location(),
                     parameters_.same_wall, parameters_.registration);
  const PoseEstimate& robot_in_local = registration.robot_in_local;
  if (is_to_be_merged(registration)) merge_scan(sighted, robot_in_local, scan);
  previous_ = {scan.utime, scan.robot_in_zero, robot_in_local};

  LocalMap local_map;
  local_map.walls = confirmed_map(walls_, robot_in_local.pose, parameters_.sighting.end_sigma);
  local_map.robot_in_local = robot_in_local;
  local_map.registered = registration.matched;
  local_map.rejected = registration.rejected;
  if (registration.unobservable)
    local_map.unobservable_direction = undirected_angle(
        perceptor::transform(*registration.unobservable, -robot_in_local.pose.a, Vector2::Zero()));
  return local_map;
}

PoseEstimate Merger::predict_pose(const ScanMap& scan) const {
  if (!previous_) return {scan.robot_in_zero, Eigen::Matrix3d::Zero()};
  const Position motion = relative(previous_->robot_in_zero, scan.robot_in_zero);
  return predict(previous_->robot_in_local, motion, seconds_between(previous_->utime, scan.utime),
                 parameters_.registration.odometry);
}

/// A scan that does not fit is left out, unless that goes on: then it is the map that is wrong.
bool Merger::is_to_be_merged(const Registration& registration) {
  rejected_in_a_row_ = registration.rejected ? rejected_in_a_row_ + 1 : 0;
  if (rejected_in_a_row_ <= parameters_.max_rejected_scans && registration.rejected) return false;
  rejected_in_a_row_ = 0;
  return true;
}

void Merger::merge_scan(const std::vector<Wall>& sighted_in_robot,
                        const PoseEstimate& robot_in_local, const ScanMap& scan) {
  const std::vector<Wall> sighted = in_local_frame(sighted_in_robot, robot_in_local);
  const Vector2 laser = perceptor::transform(robot_in_local.pose, scan.laser_in_robot.location());
  for (Wall& wall : walls_) ++wall.scans;
  forget_seen_through(walls_, sighted, laser, next_id_, parameters_.forgetting);
  std::vector<Observation> seen = merge_sighted(sighted, laser);
  merge_doubles(sighted, laser, scan.utime, seen);
  forget_contradicted(walls_, seen, laser, next_id_, parameters_.forgetting,
                      parameters_.confirmation);
  make_room(walls_, parameters_.forgetting, parameters_.confirmation);
  connect_corners(walls_, parameters_.corners, parameters_.fusion.ends);
  forget_short(walls_, parameters_.sighting.min_length);
  confirm(walls_, parameters_.confirmation);
  forget_tentative(walls_, scan.utime, parameters_.confirmation);
  forget_longest_unseen(walls_, static_cast<std::size_t>(parameters_.max_walls));
}

/// Every sighted wall is matched with the map as it was before the scan, so that the order of
/// the walls does not matter; then it is fused with its match, or begins as a tentative wall.
std::vector<Observation> Merger::merge_sighted(const std::vector<Wall>& sighted,
                                               const Vector2& laser) {
  const std::vector<Line> lines = lines_of(walls_);
  const std::vector<Match> matches =
      match_walls(sighted, walls_, lines, laser, parameters_.same_wall);
  std::vector<Observation> seen;
  seen.reserve(sighted.size());
  for (const Wall& wall : sighted) seen.push_back({kNone, wall.segment, wall.support});
  for (const Match& match : matches) {
    const Wall& wall = sighted[match.sighted];
    if (is_doorway_between(lines[match.known], line_of(wall.segment), sighted, laser,
                           parameters_.forgetting.sees_through))
      continue;
    Wall& known = walls_[match.known];
    known = fuse(known,
                 clear_of_rivals(wall, match.known, walls_, lines, parameters_.forgetting.rivals),
                 parameters_.fusion);
    seen[match.sighted].wall = known.id;
  }
  for (std::size_t i = 0; i < sighted.size(); ++i) {
    if (seen[i].wall != kNone) continue;
    walls_.push_back(sighted[i]);
    walls_.back().id = next_id_++;
    seen[i].wall = walls_.back().id;
  }
  return seen;
}

/// Walls that this scan touched may have grown together with others. The older one stays.
void Merger::merge_doubles(const std::vector<Wall>& sighted, const Vector2& laser,
                           std::int64_t utime, std::vector<Observation>& seen) {
  std::vector<Line> lines = lines_of(walls_);
  const auto are_one = [&](std::size_t i, std::size_t j) {
    const bool is_touched = walls_[i].last_seen == utime || walls_[j].last_seen == utime;
    return is_touched && !walls_[j].remove &&
           !are_far_apart(lines[i], lines[j], parameters_.same_wall) &&
           compare(walls_[i], lines[i], walls_[j], lines[j], parameters_.same_wall) &&
           !is_doorway_between(lines[i], lines[j], sighted, laser,
                               parameters_.forgetting.sees_through);
  };
  for (std::size_t i = 0; i < walls_.size(); ++i) {
    if (walls_[i].remove) continue;
    for (std::size_t j = i + 1; j < walls_.size(); ++j) {
      if (!are_one(i, j)) continue;
      walls_[i] = fuse(walls_[i], walls_[j], parameters_.fusion);
      lines[i] = line_of(walls_[i].segment);
      walls_[j].remove = true;
      rename(walls_, seen, walls_[j].id, walls_[i].id);
      j = i;  // the grown wall may reach further ones
    }
  }
  remove_marked(walls_);
}

}  // namespace perceptor::merge
