#include "components/identify/shut.hpp"

#include <algorithm>
#include <cmath>

namespace perceptor::identify {
namespace {

/// A place seen from the opening [m].
struct Place {
  double along = 0.0;   ///< from the first bound
  double before = 0.0;  ///< to the free side
};

Place seen_from(const OpeningLine& line, const Vector2& location) {
  const Vector2 from_start = location - line.start;
  return {line.along.dot(from_start), line.before.dot(from_start)};
}

double along_where(const Place& a, const Place& b, double before) {
  return a.along + (b.along - a.along) * (before - a.before) / (b.before - a.before);
}

double overlap(double a, double b, double first, double last) {
  return std::min(std::max(a, b), last) - std::max(std::min(a, b), first);
}

/// Inside the opening any contact with its line counts. Near a bound the wall has to go right
/// through: a jamb or a doubled wall begins there, and only touches the line.
bool crosses(const Place& a, const Place& b, double width, double tolerance) {
  const bool stays_on_one_side = a.before * b.before > 0.0;
  if (stays_on_one_side) return false;
  const bool lies_on_line = a.before == b.before;
  if (lies_on_line) return overlap(a.along, b.along, tolerance, width - tolerance) > 0.0;
  const double where = along_where(a, b, 0.0);
  if (where > tolerance && where < width - tolerance) return true;
  const bool is_near_bound = where > -tolerance && where < width + tolerance;
  const bool goes_through = std::min(std::abs(a.before), std::abs(b.before)) > tolerance;
  return is_near_bound && goes_through;
}

/// The part of the wall within the depths, and how much of the opening it stands across.
bool stands_across(const Place& a, const Place& b, double width,
                   const OpeningParameters& parameters) {
  const double behind = -parameters.shut_depth_behind;
  const double before = parameters.shut_depth_before;
  const auto [low, high] = std::minmax(a.before, b.before);
  if (low > before || high < behind) return false;
  const auto clipped = [&](const Place& p) {
    if (p.before < behind) return along_where(a, b, behind);
    if (p.before > before) return along_where(a, b, before);
    return p.along;
  };
  return overlap(clipped(a), clipped(b), 0.0, width) > parameters.shut_share * width;
}

}  // namespace

bool is_shut(const OpeningLine& line, const std::vector<Wall>& walls, const Wall* face,
             const OpeningParameters& parameters) {
  const Vector2 middle = line.start + 0.5 * line.width * line.along;
  const double depth = std::max(parameters.shut_depth_behind, parameters.shut_depth_before);
  const double reach = 0.5 * line.width + std::max(depth, parameters.end_tolerance);
  return std::ranges::any_of(walls, [&](const Wall& wall) {
    if (&wall == face || is_out_of_reach(wall, middle, reach)) return false;
    const Place a = seen_from(line, wall.ends[0].location);
    const Place b = seen_from(line, wall.ends[1].location);
    return crosses(a, b, line.width, parameters.end_tolerance) ||
           stands_across(a, b, line.width, parameters);
  });
}

}  // namespace perceptor::identify
