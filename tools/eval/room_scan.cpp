#include "tools/eval/room_scan.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "tools/eval/room_random.hpp"

namespace perceptor {
namespace {

constexpr double kSecondsPerScan = 0.05;
constexpr double kSmallestClaimedSigma = 0.001;  // [m]

/// As perceptor::cross, in place: it is asked for every beam and wall.
inline double cross_of(const Vector2& a, const Vector2& b) {
  return (a.x() * b.y()) - (a.y() * b.x());
}

/// How far the ray goes from the origin to the free side of the wall; none where it misses.
std::optional<double> range_to(const Segment& wall, const Vector2& ray) {
  const Vector2 along = wall.b - wall.a;
  const double approach = cross_of(ray, along);
  const bool meets_free_side = approach > 0.0;
  if (!meets_free_side) return std::nullopt;
  // So wide that no ray slips through a corner between two walls.
  constexpr double kRounding = 1e-12;
  const double share = cross_of(wall.a, ray) / approach;
  if (share < -kRounding || share > 1.0 + kRounding) return std::nullopt;
  const double range = cross_of(wall.a, along) / approach;
  if (range <= 0.0) return std::nullopt;
  return range;
}

/// Whether the corner at the end of the first piece's wall is seen from both sides.
bool meet(const std::vector<PlanWall>& walls, const TruePiece& piece, const TruePiece& following,
          const TruthLimits& limits) {
  const bool are_neighbours = walls[static_cast<std::size_t>(piece.edge)].next == following.edge;
  const bool follow_each_other = piece.last_beam + 1 == following.first_beam;
  const std::size_t fewer_returns = std::min(piece.returns, following.returns);
  return are_neighbours && follow_each_other && fewer_returns >= limits.min_corner_returns;
}

}  // namespace

std::vector<double> bearings(const RoomLaser& laser) {
  if (laser.beams < 2) throw std::invalid_argument("a laser needs at least 2 beams");
  const double increment = laser.fov / static_cast<double>(laser.beams - 1);
  std::vector<double> bearings;
  for (std::size_t beam = 0; beam < laser.beams; ++beam)
    bearings.push_back(-0.5 * laser.fov + static_cast<double>(beam) * increment);
  return bearings;
}

std::vector<std::optional<BeamTarget>> beam_targets(const std::vector<PlanWall>& walls,
                                                    const Position& laser_in_world,
                                                    const RoomLaser& laser) {
  const Position world_in_laser = inverse(laser_in_world);
  std::vector<Segment> in_laser;
  in_laser.reserve(walls.size());
  for (const PlanWall& wall : walls) in_laser.push_back(transform(world_in_laser, wall.segment));

  std::vector<std::optional<BeamTarget>> targets;
  for (const double bearing : bearings(laser)) {
    const Vector2 ray(std::cos(bearing), std::sin(bearing));
    std::optional<BeamTarget> nearest;
    for (std::size_t i = 0; i < in_laser.size(); ++i) {
      const std::optional<double> range = range_to(in_laser[i], ray);
      if (range && (!nearest || *range < nearest->range))
        nearest = {static_cast<int>(i), *range, *range * ray};
    }
    const bool is_measurable =
        nearest && nearest->range >= laser.range_min && nearest->range <= laser.range_max;
    targets.push_back(is_measurable ? nearest : std::nullopt);
  }
  return targets;
}

Measurement measure(const std::vector<std::optional<BeamTarget>>& targets, const RoomLaser& laser,
                    std::uint64_t seed, std::uint64_t scan) {
  RoomRandom noise = make_room_stream(seed, scan, RoomStream::range_noise);
  RoomRandom outliers = make_room_stream(seed, scan, RoomStream::outliers);
  RoomRandom dropouts = make_room_stream(seed, scan, RoomStream::dropouts);
  Measurement measurement;
  for (const std::optional<BeamTarget>& target : targets) {
    // Each stream is drawn from alike for each beam, whatever becomes of it.
    const double deviation = laser.sigma * normal(noise);
    const bool is_outlier = happens(outliers, laser.outliers);
    const double anywhere = uniform(outliers, laser.range_min, laser.range_max);
    const bool is_lost = happens(dropouts, laser.dropouts);

    const double measured = target ? target->range + deviation : 0.0;
    const double range = is_outlier ? anywhere : measured;
    const bool returns = !is_lost && range >= laser.range_min && range <= laser.range_max;
    measurement.ranges.push_back(returns ? range : 0.0);
    measurement.is_of_the_target.push_back(returns && !is_outlier);
  }
  return measurement;
}

std::vector<TruePiece> true_pieces(const std::vector<std::optional<BeamTarget>>& targets,
                                   const std::vector<bool>& is_of_the_target,
                                   const TruthLimits& limits) {
  std::vector<TruePiece> pieces;
  std::optional<int> wall_before;
  for (std::size_t beam = 0; beam < targets.size(); ++beam) {
    const std::optional<BeamTarget>& target = targets[beam];
    if (target) {
      if (target->wall != wall_before)
        pieces.push_back({.edge = target->wall,
                          .first_beam = beam,
                          .segment = {target->location, target->location}});
      TruePiece& piece = pieces.back();
      piece.last_beam = beam;
      piece.segment.b = target->location;
      piece.returns += is_of_the_target[beam] ? 1 : 0;
    }
    wall_before = target ? std::optional(target->wall) : std::nullopt;
  }
  for (TruePiece& piece : pieces)
    piece.has_to_be_found =
        piece.returns >= limits.min_returns && length(piece.segment) >= limits.min_length;
  return pieces;
}

std::vector<TrueCorner> true_corners(const std::vector<PlanWall>& walls,
                                     const std::vector<TruePiece>& pieces,
                                     const Position& laser_in_world, const TruthLimits& limits) {
  const Position world_in_laser = inverse(laser_in_world);
  std::vector<TrueCorner> corners;
  for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
    if (!meet(walls, pieces[i], pieces[i + 1], limits)) continue;
    const PlanWall& wall = walls[static_cast<std::size_t>(pieces[i].edge)];
    corners.push_back(
        {.location = transform(world_in_laser, wall.segment.b),
         .is_convex = wall.ends_in_convex,
         .has_to_be_found = pieces[i].has_to_be_found && pieces[i + 1].has_to_be_found});
  }
  return corners;
}

LabelledScan scan_room(const std::vector<PlanWall>& walls, const Position& laser_in_world,
                       const RoomLaser& laser, std::uint64_t seed, std::uint64_t scan) {
  const auto targets = beam_targets(walls, laser_in_world, laser);
  const Measurement measurement = measure(targets, laser, seed, scan);

  LabelledScan labelled;
  labelled.id = static_cast<std::int64_t>(scan);
  labelled.time = kSecondsPerScan * static_cast<double>(scan);
  labelled.odometry = laser_in_world;
  labelled.laser_in_world = laser_in_world;
  labelled.scan.valid_min = laser.range_min;
  labelled.scan.valid_max = laser.range_max;
  labelled.scan.range_sigma = std::max(laser.sigma, kSmallestClaimedSigma);
  labelled.scan.bearings = bearings(laser);
  labelled.scan.ranges = measurement.ranges;
  labelled.pieces = true_pieces(targets, measurement.is_of_the_target);
  labelled.corners = true_corners(walls, labelled.pieces, laser_in_world);
  return labelled;
}

}  // namespace perceptor
