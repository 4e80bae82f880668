#include "components/merge/forgetting.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
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

/// The weight does not bear one more scan that speaks against the wall.
bool is_used_up(const Wall& wall, const ForgettingParameters& parameters) {
  return wall.weight * parameters.factor < parameters.min_weight;
}

/// Halves the weight of the walls that have a piece against them, and cuts it out of the tentative
/// ones and of those whose weight is used up: a shorter wall, two, or none remain.
void weaken(std::vector<Wall>& walls, const std::vector<std::optional<Interval>>& against,
            std::int32_t& next_id, const ForgettingParameters& parameters) {
  std::vector<Wall> added;
  for (std::size_t i = 0; i < against.size(); ++i) {
    if (!against[i]) continue;
    Wall& wall = walls[i];
    const bool withstands = wall.confirmed && !is_used_up(wall, parameters);
    wall.weight *= parameters.factor;
    if (withstands) continue;

    const Interval widened =
        with_margins(*against[i], length(wall.segment), 2.0 * parameters.sees_through.end_margin);
    const std::vector<Wall> pieces = cut(wall, widened, parameters.min_piece);
    wall.remove = pieces.empty();
    if (!pieces.empty()) wall = pieces.front();
    for (std::size_t k = 1; k < pieces.size(); ++k) {
      added.push_back(pieces[k]);
      added.back().id = next_id++;
    }
  }
  walls.insert(walls.end(), added.begin(), added.end());
  remove_marked(walls);
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
      const Wall& wall = walls[neighbour];
      if (wall.confirmed || wall.contested || !was_seen_steadily(wall, parameters)) continue;
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
  std::vector<std::optional<Interval>> openings;
  openings.reserve(walls.size());
  for (Wall& wall : walls) {
    openings.push_back(widest_opening(wall.segment, laser, sighted, parameters.sees_through));
    wall.doubted = wall.doubted || openings.back();
  }
  weaken(walls, openings, next_id, parameters);
}

void forget_contradicted(std::vector<Wall>& walls, const std::vector<Observation>& seen,
                         const Vector2& laser, std::int32_t& next_id,
                         const ForgettingParameters& parameters,
                         const ConfirmationParameters& confirmation) {
  std::vector<std::optional<Interval>> pieces(walls.size());
  for (const Contradiction& found : contradictions(walls, seen, laser, parameters.rivals)) {
    const Wall& wall = walls[found.wall];
    Wall& rival = walls[found.rival];
    const bool is_certain = rival.confirmed || was_seen_steadily(rival, confirmation);
    const bool stays = wall.confirmed && !(is_certain && is_used_up(wall, parameters));
    if (stays && !rival.confirmed) rival.contested = true;
    std::optional<Interval>& piece = pieces[found.wall];
    if (is_certain && (!piece || found.piece.length() > piece->length())) piece = found.piece;
  }
  for (std::size_t i = 0; i < walls.size(); ++i) walls[i].doubted = pieces[i].has_value();
  weaken(walls, pieces, next_id, parameters);
}

void make_room(std::vector<Wall>& walls, const ForgettingParameters& parameters,
               const ConfirmationParameters& confirmation) {
  for (Wall& wall : walls) {
    if (wall.confirmed || wall.contested || !was_seen_steadily(wall, confirmation)) continue;
    const Interval free = free_piece(wall, walls, parameters.rivals);
    const bool is_whole = free.length() >= length(wall.segment);
    wall.remove = free.length() < parameters.min_piece;
    if (!is_whole && !wall.remove) {
      const Wall whole = wall;
      wall = piece_of(whole, free);
      give_radius(wall, whole);
    }
  }
  remove_marked(walls);
}

void confirm(std::vector<Wall>& walls, const ConfirmationParameters& parameters) {
  std::vector<std::size_t> confirmed;
  for (std::size_t i = 0; i < walls.size(); ++i) {
    Wall& wall = walls[i];
    const bool is_certain =
        wall.sightings >= parameters.sightings && was_seen_steadily(wall, parameters);
    if (!wall.confirmed && !wall.contested && is_certain) {
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
