#include "components/scan/corners.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/LU>

#include "components/scan/cuts.hpp"

namespace perceptor::scan {
namespace {

/// A wall ends at a cut where no more than this many beams at the cut do not support it.
constexpr std::size_t kLooseBeams = 3;

/// Steps of bearing without a return over which a jump in range is still seen as one.
constexpr double kMostSteps = 5.0;

/// Two runs that follow each other.
struct Cut {
  const Run& before;
  const Run& after;
  const Wall* wall_before = nullptr;  ///< that ends at the cut, if one does
  const Wall* wall_after = nullptr;   ///< that begins at the cut, if one does

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

/// Left turns, as the laser goes round, are the inside of a room.
PointProperty property_of_turn(const Vector2& before, const Vector2& after) {
  return cross(before, after) > 0.0 ? PointProperty::concave : PointProperty::convex;
}

PolarLine polar_line(const Line& line, const Vector2& laser) {
  const Vector2 place = -line.normal / offset(line, laser);
  return {.a = place.x(), .b = place.y()};
}

/// Where the cut would be if the walls met at a place.
std::size_t first_beam_beyond(const Vector2& place, const Cut& cut, const Beams& beams) {
  const Vector2 from_laser = place - beams.laser;
  const auto is_beyond = [&](std::size_t i) { return !(cross(beams.end(i), from_laser) > 0.0); };
  const std::size_t end = std::min(cut.after.end, beams.is_circle ? 2 * beams.count : beams.count);
  std::size_t i = cut.next();
  while (i > cut.before.begin && is_beyond(i - 1)) --i;
  while (i < end && !is_beyond(i)) ++i;
  return i;
}

/// Where the nearer of two walls ends, and the other goes on behind it.
Corner end_of_nearer(const Cut& cut, const Beams& beams) {
  const bool is_before = beams.range[cut.last()] < beams.range[cut.next()];
  return {.place = is_before ? cut.wall_before->last : cut.wall_after->first,
          .method = CornerMethod::spike,
          .property = PointProperty::convex,
          .beam = is_before ? cut.last() : cut.next()};
}

/// Where the walls on both sides of the cut meet, close to the end of both; or, where beams pass
/// between them, the end of the nearer one.
std::optional<Corner> meeting_point(const Cut& cut, const Beams& beams,
                                    const ScanParameters& parameters) {
  if (cut.wall_before == nullptr || cut.wall_after == nullptr) return std::nullopt;
  const Wall& first = *cut.wall_before;
  const Wall& second = *cut.wall_after;
  const double sine = std::abs(cross(first.line.direction, second.line.direction));
  if (sine < std::sin(parameters.corner.min_angle)) return std::nullopt;

  const Vector2 place = intersection(first.line, second.line);
  const auto is_within_reach = [&](const Wall& wall, const WallEnd& end, std::size_t beam) {
    const double reach =
        parameters.corner.reach + 2.0 * distance_between_beams(beams, beam, wall.line.normal);
    return distance(place, end.location) <= reach;
  };
  if (!is_within_reach(first, first.last, first.last_beam) ||
      !is_within_reach(second, second.first, second.first_beam))
    return std::nullopt;
  const WallEnd end = {.location = place,
                       .covariance = intersection_covariance(first, second, place)};
  if (pass_by(polar_line(first.line, beams.laser), polar_line(second.line, beams.laser),
              first_beam_beyond(place, cut, beams), cut.next(),
              std::max(first.excess, second.excess), beams))
    return end_of_nearer(cut, beams);
  return Corner{.place = end,
                .method = CornerMethod::intersection,
                .property = property_of_turn(first.line.direction, second.line.direction),
                .beam = cut.next()};
}

bool has_beams_for_corner(const Run& run, const ScanParameters& parameters) {
  return run.size() >= static_cast<std::size_t>(parameters.corner.min_beams);
}

/// Of the end of a single beam: along it by its noise, across it by the step between beams.
WallEnd end_of(const Beams& beams, std::size_t i) {
  const Vector2 along = unit(beams.end(i));
  const Vector2 sideways = perpendicular(along);
  const double noise = beams.sigma(i) * beams.sigma(i);
  const double step = beams.range[i] * beams.increment;
  const double across = step * step / 3.0;
  return {
      .location = beams.location(i),
      .covariance = noise * along * along.transpose() + across * sideways * sideways.transpose()};
}

/// The nearer of the two beams at a cut, where the range jumps between them.
std::optional<Corner> spike(const Cut& cut, const Beams& beams, const ScanParameters& parameters) {
  const double jump = beams.range[cut.next()] - beams.range[cut.last()];
  const double step = beams.bearing[cut.next()] - beams.bearing[cut.last()];
  const bool is_jump = step <= kMostSteps * beams.increment &&
                       std::abs(jump) >= parameters.corner.spike_jump &&
                       is_gap(beams, cut.last(), cut.next());
  if (!is_jump) return std::nullopt;
  const bool is_before = jump > 0.0;
  const std::size_t nearer = is_before ? cut.last() : cut.next();
  const Wall* wall = is_before ? cut.wall_before : cut.wall_after;
  if (wall == nullptr && !has_beams_for_corner(is_before ? cut.before : cut.after, parameters))
    return std::nullopt;
  Corner corner{.place = end_of(beams, nearer),
                .method = CornerMethod::spike,
                .property = PointProperty::convex,
                .beam = nearer};
  if (wall != nullptr) corner.place = is_before ? wall->last : wall->first;
  return corner;
}

/// Where the direction turns from one run to the next that follows it, one of which is no wall:
/// two walls meet at their lines' crossing or not at all.
std::optional<Corner> vector_corner(const Cut& cut, const Beams& beams,
                                    const ScanParameters& parameters) {
  if (cut.wall_before != nullptr && cut.wall_after != nullptr) return std::nullopt;
  const bool has_beams =
      has_beams_for_corner(cut.before, parameters) && has_beams_for_corner(cut.after, parameters);
  if (!has_beams || !follows(beams, cut.before, cut.after)) return std::nullopt;
  const Line first = make_line(polar_line(cut.before.moments), beams.laser);
  const Line second = make_line(polar_line(cut.after.moments), beams.laser);
  const double sine = std::abs(cross(first.direction, second.direction));
  // Beams that all lie in one direction have no line, and then this is no number.
  if (!(sine > std::sin(parameters.corner.vector_angle))) return std::nullopt;
  Corner corner{.place = end_of(beams, cut.next()),
                .method = CornerMethod::vector,
                .property = property_of_turn(first.direction, second.direction),
                .beam = cut.next()};
  if (cut.wall_after != nullptr) corner.place = cut.wall_after->first;
  if (cut.wall_before != nullptr) corner.place = cut.wall_before->last;
  return corner;
}

}  // namespace

void find_corners(const std::vector<RunResult>& runs, const std::vector<Wall>& walls,
                  const Beams& beams, const ScanParameters& parameters,
                  std::vector<Corner>& corners) {
  corners.clear();
  if (runs.empty()) return;
  const std::size_t cuts = beams.is_circle ? runs.size() : runs.size() - 1;
  for (std::size_t i = 0; i < cuts; ++i) {
    const bool passes_seam = i + 1 == runs.size();
    const RunResult& before = runs[i];
    const RunResult& after = runs[passes_seam ? 0 : i + 1];
    const Run run_after = passes_seam ? past_seam(after.run, beams) : after.run;
    const std::size_t turned = passes_seam ? beams.count : 0;

    Cut cut{.before = before.run, .after = run_after};
    if (before.wall != kNoWall && walls[before.wall].last_beam + kLooseBeams >= cut.last())
      cut.wall_before = &walls[before.wall];
    if (after.wall != kNoWall && walls[after.wall].first_beam + turned <= cut.next() + kLooseBeams)
      cut.wall_after = &walls[after.wall];

    std::optional<Corner> corner = meeting_point(cut, beams, parameters);
    if (!corner) corner = spike(cut, beams, parameters);
    if (!corner) corner = vector_corner(cut, beams, parameters);
    if (!corner) continue;
    const bool sees_before = corner->method != CornerMethod::spike || corner->beam == cut.last();
    const bool sees_after = corner->method != CornerMethod::spike || corner->beam == cut.next();
    if (cut.wall_before != nullptr && sees_before) corner->before = before.wall;
    if (cut.wall_after != nullptr && sees_after) corner->after = after.wall;
    corners.push_back(*corner);
  }
}

}  // namespace perceptor::scan
