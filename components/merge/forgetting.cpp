#include "components/merge/forgetting.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "common/time/stamp.hpp"

namespace perceptor::merge {
namespace {

/// The part of a wall between two places, in metres from its tail. An end that was cut is only
/// known to be where the opening begins.
Wall piece_of(const Wall& wall, const Interval& part) {
  const double whole = length(wall.segment);
  const Vector2 along = direction(wall.segment);
  Wall piece = wall;
  set_ends(piece, {wall.segment.a + part.from * along, wall.segment.a + part.to * along});
  if (part.from > 0.0) piece.ends[kTail] = {};
  if (part.to < whole) piece.ends[kHead] = {};
  return piece;
}

/// Loose ends of a cut reach as far for a corner as those of the wall did.
void give_radius(Wall& piece, const Wall& wall) {
  for (const std::size_t i : {kTail, kHead}) {
    if (piece.ends[i].radius > 0.0) continue;
    piece.ends[i].radius = std::max(wall.ends[kTail].radius, wall.ends[kHead].radius);
    piece.ends[i].variance = std::max(wall.ends[kTail].variance, wall.ends[kHead].variance);
  }
}

/// What remains beside the opening.
std::vector<Wall> cut(const Wall& wall, const Interval& opening, double min_piece) {
  const Interval before{0.0, opening.from};
  const Interval after{opening.to, length(wall.segment)};
  std::vector<Wall> pieces;
  for (const Interval& part : {before, after}) {
    if (part.to - part.from < min_piece) continue;
    pieces.push_back(piece_of(wall, part));
    give_radius(pieces.back(), wall);
  }
  return pieces;
}

/// The opening reaches the end of the wall where only the margin is left beside it: rays there
/// say nothing, and a wall does not end in a stub.
Interval with_margins(Interval opening, double wall_length, double margin) {
  if (opening.from <= margin) opening.from = 0.0;
  if (opening.to >= wall_length - margin) opening.to = wall_length;
  return opening;
}

bool was_seen_steadily(const Wall& wall, const ConfirmationParameters& parameters) {
  return seconds_between(wall.first_seen, wall.last_seen) >= parameters.min_time &&
         wall.sightings >= parameters.min_share * wall.scans;
}

void confirm_neighbours(std::vector<Wall>& walls, std::vector<std::size_t>& newly_confirmed,
                        const ConfirmationParameters& parameters) {
  const auto index_of = [&walls](std::int32_t id) {
    const auto found =
        std::lower_bound(walls.begin(), walls.end(), id,
                         [](const Wall& wall, std::int32_t wanted) { return wall.id < wanted; });
    return static_cast<std::size_t>(found - walls.begin());
  };
  while (!newly_confirmed.empty()) {
    const std::size_t i = newly_confirmed.back();
    newly_confirmed.pop_back();
    for (const WallEnd& end : walls[i].ends) {
      if (end.connected == kNone) continue;
      const std::size_t neighbour = index_of(end.connected);
      if (walls[neighbour].confirmed || !was_seen_steadily(walls[neighbour], parameters)) continue;
      walls[neighbour].confirmed = true;
      walls[neighbour].is_new = true;
      newly_confirmed.push_back(neighbour);
    }
  }
}

}  // namespace

void forget_seen_through(std::vector<Wall>& walls, const std::vector<Wall>& sighted,
                         const Vector2& laser, std::int32_t& next_id,
                         const ForgettingParameters& parameters) {
  std::vector<Wall> added;
  for (Wall& wall : walls) {
    const auto opening = widest_opening(wall.segment, laser, sighted, parameters.sees_through);
    wall.doubted = opening.has_value();
    if (!opening) continue;
    wall.weight *= parameters.factor;
    const bool withstands = wall.confirmed && wall.weight >= parameters.min_weight;
    if (withstands) continue;

    const Interval widened =
        with_margins(*opening, length(wall.segment), 2.0 * parameters.sees_through.end_margin);
    const std::vector<Wall> pieces = cut(wall, widened, parameters.min_piece);
    wall.remove = pieces.empty();
    if (!pieces.empty()) wall = pieces.front();
    for (std::size_t i = 1; i < pieces.size(); ++i) {
      added.push_back(pieces[i]);
      added.back().id = next_id++;
    }
  }
  walls.insert(walls.end(), added.begin(), added.end());
  remove_marked(walls);
}

void confirm(std::vector<Wall>& walls, const ConfirmationParameters& parameters) {
  std::vector<std::size_t> confirmed;
  for (std::size_t i = 0; i < walls.size(); ++i) {
    Wall& wall = walls[i];
    const bool is_certain =
        wall.sightings >= parameters.sightings && was_seen_steadily(wall, parameters);
    if (!wall.confirmed && is_certain) {
      wall.confirmed = true;
      wall.is_new = true;
    }
    if (wall.confirmed) confirmed.push_back(i);
  }
  confirm_neighbours(walls, confirmed, parameters);
}

void forget_tentative(std::vector<Wall>& walls, std::int64_t utime,
                      const ConfirmationParameters& parameters) {
  for (Wall& wall : walls)
    wall.remove =
        !wall.confirmed && seconds_between(wall.last_seen, utime) > parameters.tentative_time;
  remove_marked(walls);
}

void forget_short(std::vector<Wall>& walls, double min_length) {
  for (Wall& wall : walls) wall.remove = length(wall.segment) < min_length;
  remove_marked(walls);
}

void forget_longest_unseen(std::vector<Wall>& walls, std::size_t max_walls) {
  if (walls.size() <= max_walls) return;
  std::vector<std::size_t> order(walls.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto worth = [&walls](std::size_t i) {
    const Wall& wall = walls[i];
    return std::tuple(wall.last_seen, wall.confirmed, wall.weight, length(wall.segment), -wall.id);
  };
  std::sort(order.begin(), order.end(),
            [&worth](std::size_t i, std::size_t j) { return worth(i) < worth(j); });
  order.resize(walls.size() - max_walls);
  for (const std::size_t i : order) walls[i].remove = true;
  remove_marked(walls);
}

}  // namespace perceptor::merge
