#include "components/scan/corners.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/LU>

namespace perceptor::scan {
namespace {

/// A wall ends at a cut where no more than this many beams at the cut do not support it.
constexpr std::size_t kLooseBeams = 3;

/// Steps of bearing without a return over which a jump in range is still seen as one.
constexpr double kMostSteps = 5.0;

/// Two runs that follow each other.
struct Cut {
  Run before;
  Run after;
  Wall* wall_before = nullptr;  ///< that ends at the cut, if one does
  Wall* wall_after = nullptr;   ///< that begins at the cut, if one does

  std::size_t last() const { return before.end - 1; }
  std::size_t next() const { return after.begin; }
};

/// Covariance of where two lines meet, from that of each across itself.
Eigen::Matrix2d intersection_covariance(const Wall& first, const Wall& second,
                                        const Vector2& place) {
  Eigen::Matrix2d normals;
  normals.row(0) = first.line.normal.transpose();
  normals.row(1) = second.line.normal.transpose();
  const Eigen::Matrix2d place_of_offsets = normals.inverse();
  const Eigen::Vector2d variances(variance_across(first, place), variance_across(second, place));
  return place_of_offsets * variances.asDiagonal() * place_of_offsets.transpose();
}

/// Where the walls on both sides of the cut meet, close to the end of both.
std::optional<WallEnd> meeting_point(const Cut& cut, const Beams& beams,
                                     const ScanParameters& parameters) {
  if (cut.wall_before == nullptr || cut.wall_after == nullptr) return std::nullopt;
  const Wall& first = *cut.wall_before;
  const Wall& second = *cut.wall_after;
  const double sine = std::abs(cross(first.line.direction, second.line.direction));
  if (sine < std::sin(parameters.corner.min_angle)) return std::nullopt;

  const Vector2 place = intersection(first.line, second.line);
  const auto is_within_reach = [&](const Wall& wall, const WallEnd& end, std::size_t beam) {
    const double reach = parameters.corner.reach +
                         2.0 * distance_between_beams(beams, beams[beam], wall.line.normal);
    return distance(place, end.location) <= reach;
  };
  if (!is_within_reach(first, first.last, first.last_beam) ||
      !is_within_reach(second, second.first, second.first_beam))
    return std::nullopt;
  return WallEnd{.location = place, .covariance = intersection_covariance(first, second, place)};
}

/// The nearer of the two beams at a cut, where the range jumps between them.
std::optional<std::size_t> spike(const Cut& cut, const Beams& beams,
                                 const ScanParameters& parameters) {
  const double jump = beams[cut.next()].range - beams[cut.last()].range;
  const double step =
      std::remainder(beams[cut.next()].bearing - beams[cut.last()].bearing, 2.0 * std::numbers::pi);
  const bool is_jump = std::abs(step) <= kMostSteps * beams.increment &&
                       std::abs(jump) >= parameters.corner.spike_jump &&
                       is_gap(beams, cut.last(), cut.next());
  if (!is_jump) return std::nullopt;
  return jump > 0.0 ? cut.last() : cut.next();
}

/// Whether the direction turns between two runs that adjoin.
bool is_vector_corner(const Cut& cut, const Beams& beams, const ScanParameters& parameters) {
  if (!adjoin(beams, cut.before, cut.after)) return false;
  const Line first = fit_line(cut.before.moments, beams.laser);
  const Line second = fit_line(cut.after.moments, beams.laser);
  const double sine = std::abs(cross(first.direction, second.direction));
  return sine > std::sin(parameters.corner.vector_angle);
}

/// Of the end of a single beam: along it by its noise, across it by the step between beams.
WallEnd end_of(const Beam& beam, double increment) {
  const double along = beam.sigma * beam.sigma;
  const double step = beam.range * increment;
  const double across = step * step / 3.0;
  const Vector2 sideways = perpendicular(beam.along);
  return {.location = beam.location,
          .covariance = along * beam.along * beam.along.transpose() +
                        across * sideways * sideways.transpose()};
}

bool has_beams_for_corner(const Run& run, const ScanParameters& parameters) {
  return run.size() >= static_cast<std::size_t>(parameters.corner.min_beams);
}

/// Says of each wall at the cut how its corner was seen; gives the corner without a wall.
std::optional<LoneCorner> look_at(const Cut& cut, WallCorners& before, WallCorners& after,
                                  const Beams& beams, const ScanParameters& parameters) {
  if (const std::optional<WallEnd> meeting = meeting_point(cut, beams, parameters)) {
    cut.wall_before->last = *meeting;
    cut.wall_after->first = *meeting;
    before.last = CornerMethod::intersection;
    after.first = CornerMethod::intersection;
    return std::nullopt;
  }
  if (const std::optional<std::size_t> nearer = spike(cut, beams, parameters)) {
    const bool is_before = *nearer == cut.last();
    const bool has_wall = (is_before ? cut.wall_before : cut.wall_after) != nullptr;
    if (has_wall) {
      (is_before ? before.last : after.first) = CornerMethod::spike;
      return std::nullopt;
    }
    if (!has_beams_for_corner(is_before ? cut.before : cut.after, parameters)) return std::nullopt;
    return LoneCorner{.place = end_of(beams[*nearer], beams.increment),
                      .method = CornerMethod::spike,
                      .beam = *nearer};
  }
  const bool has_beams =
      has_beams_for_corner(cut.before, parameters) && has_beams_for_corner(cut.after, parameters);
  if (!has_beams || !is_vector_corner(cut, beams, parameters)) return std::nullopt;
  if (cut.wall_before != nullptr) before.last = CornerMethod::vector;
  if (cut.wall_after != nullptr) after.first = CornerMethod::vector;
  if (cut.wall_before != nullptr || cut.wall_after != nullptr) return std::nullopt;
  return LoneCorner{.place = end_of(beams[cut.next()], beams.increment),
                    .method = CornerMethod::vector,
                    .beam = cut.next()};
}

}  // namespace

Corners find_corners(const std::vector<Run>& runs, std::vector<std::optional<Wall>>& walls,
                     const Beams& beams, const ScanParameters& parameters) {
  Corners corners;
  corners.of_walls.resize(runs.size());
  const std::size_t cuts =
      beams.is_circle ? runs.size() : runs.size() - std::min<std::size_t>(runs.size(), 1);
  for (std::size_t i = 0; i < cuts; ++i) {
    const std::size_t j = (i + 1) % runs.size();
    Cut cut{.before = runs[i], .after = j > i ? runs[j] : past_seam(runs[j], beams)};
    if (walls[i] && walls[i]->last_beam + kLooseBeams >= cut.last()) cut.wall_before = &*walls[i];
    const std::size_t turned = j > i ? 0 : beams.count;
    if (walls[j] && walls[j]->first_beam + turned <= cut.next() + kLooseBeams)
      cut.wall_after = &*walls[j];
    const std::optional<LoneCorner> lone =
        look_at(cut, corners.of_walls[i], corners.of_walls[j], beams, parameters);
    if (lone) corners.lone.push_back(*lone);
  }
  return corners;
}

}  // namespace perceptor::scan
