#include "components/identify/hallway.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "components/identify/crossing.hpp"
#include "components/identify/hallway_sides.hpp"

namespace perceptor::identify {
namespace {

bool belongs_to(const Wall& wall, const Side& side) {
  return std::ranges::any_of(side, [&](const Piece& piece) { return piece.wall == &wall; });
}

/// Where the hallway ends before and behind the robot, because a wall crosses its centre line.
Interval cut_at_walls(const Interval& interval, double centre, const std::vector<Wall>& walls,
                      const View& view) {
  Interval left_over = interval;
  const Segment line{view.place(interval.from, centre), view.place(interval.to, centre)};
  for (const Wall& wall : walls) {
    if (!cross_each_other(line, segment_of(wall))) continue;
    const Piece piece = view.piece(wall);
    const double share = (centre - piece.offset[0]) / (piece.offset[1] - piece.offset[0]);
    const double where = piece.along.from + share * piece.along.length();
    if (where > 0.0) left_over.to = std::min(left_over.to, where);
    if (where <= 0.0) left_over.from = std::max(left_over.from, where);
  }
  return left_over;
}

/// Whether a wall stands between the robot and one of the sides.
bool is_across(const std::vector<Wall>& walls, const View& view, const Side& left, double left_at,
               const Side& right, double right_at) {
  const Segment across{view.place(0.0, left_at), view.place(0.0, right_at)};
  return std::ranges::any_of(walls, [&](const Wall& wall) {
    return cross_each_other(across, segment_of(wall)) && !belongs_to(wall, left) &&
           !belongs_to(wall, right);
  });
}

std::optional<Hallway> between(const Side& left, const Side& right, const std::vector<Wall>& walls,
                               const View& view, const HallwayParameters& parameters) {
  const Interval reach{-parameters.reach, parameters.reach};
  const Interval both = common_part(common_part(extent(left), extent(right)), reach);
  if (!both.contains(0.0)) return std::nullopt;
  const double left_at = mean_offset(left, both);
  const double right_at = mean_offset(right, both);
  const double width = left_at - right_at;
  if (width < parameters.min_width || width > parameters.max_width) return std::nullopt;
  const bool is_between = left_at > 0.0 && right_at < 0.0;
  if (!is_between) return std::nullopt;
  if (is_across(walls, view, left, left_at, right, right_at)) return std::nullopt;

  const double centre = 0.5 * (left_at + right_at);
  const Interval open = cut_at_walls(both, centre, walls, view);
  if (open.length() < std::max(parameters.min_length, parameters.min_elongation * width))
    return std::nullopt;
  const double wall_needed = parameters.min_cover * open.length();
  if (covered(left, open) < wall_needed || covered(right, open) < wall_needed) return std::nullopt;

  Hallway hallway{view.place(open.from, centre), view.place(open.to, centre), width};
  if (hallway.back.x() > hallway.front.x()) std::swap(hallway.back, hallway.front);
  return hallway;
}

/// The walls that the robot is beside, or beside the doorway next to them: the longest first,
/// and then by their place, so that their order in the map does not show.
std::vector<const Wall*> walls_beside(const std::vector<Wall>& walls, const Vector2& robot,
                                      const HallwayParameters& parameters) {
  std::vector<const Wall*> beside;
  for (const Wall& wall : walls) {
    const Vector2 to_robot = robot - wall.middle;
    const double before = wall.free.dot(to_robot);
    const double past = std::abs(cross(wall.free, to_robot)) - 0.5 * wall.length;
    const bool is_beside =
        before > 0.0 && before <= parameters.max_width && past <= parameters.max_gap;
    if (is_beside) beside.push_back(&wall);
  }
  std::ranges::sort(beside, [](const Wall* a, const Wall* b) {
    return std::tuple(-a->length, a->middle.x(), a->middle.y()) <
           std::tuple(-b->length, b->middle.x(), b->middle.y());
  });
  return beside;
}

}  // namespace

std::optional<Hallway> find_hallway(const std::vector<Wall>& walls, const Vector2& robot,
                                    const HallwayParameters& parameters) {
  std::optional<Hallway> narrowest;
  for (const Wall* seed : walls_beside(walls, robot, parameters)) {
    const View view(robot, *seed);
    const Side left =
        side_along(facing_pieces(walls, view, 1.0, parameters), view.piece(*seed), parameters);
    const Side opposite = facing_pieces(walls, view, -1.0, parameters);
    for (const Piece& piece : opposite) {
      const double past = std::max(piece.along.from, -piece.along.to);
      if (past > parameters.max_gap) continue;
      const Side right = side_along(opposite, piece, parameters);
      const auto hallway = between(left, right, walls, view, parameters);
      const bool is_narrower =
          hallway && (!narrowest || hallway->width < narrowest->width - parameters.max_offset);
      if (is_narrower) narrowest = hallway;
    }
  }
  return narrowest;
}

}  // namespace perceptor::identify
