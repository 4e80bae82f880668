#include "components/identify/hallway_sides.hpp"

#include <cmath>

namespace perceptor::identify {

Side facing_pieces(const std::vector<Wall>& walls, const View& view, double side,
                   const HallwayParameters& parameters) {
  const double min_cosine = std::cos(parameters.max_angle);
  Side pieces;
  for (const Wall& wall : walls) {
    const bool looks_at_robot = -side * wall.free.dot(view.left()) >= min_cosine;
    if (!looks_at_robot) continue;
    const Piece piece = view.piece(wall);
    const double offset = side * piece.middle_offset();
    if (offset > 0.0 && offset <= parameters.max_width) pieces.push_back(piece);
  }
  std::ranges::sort(pieces, {}, [](const Piece& p) { return p.along.from; });
  return pieces;
}

Side side_along(const Side& pieces, const Piece& seed, const HallwayParameters& parameters) {
  Side run;
  double reached = 0.0;
  bool has_seed = false;
  for (const Piece& piece : pieces) {
    const double off = std::abs(piece.middle_offset() - seed.middle_offset());
    if (off > parameters.max_offset) continue;
    const bool is_apart = !run.empty() && piece.along.from - reached > parameters.max_gap;
    if (is_apart && has_seed) break;
    if (is_apart) run.clear();
    reached = run.empty() ? piece.along.to : std::max(reached, piece.along.to);
    has_seed |= piece.wall == seed.wall;
    run.push_back(piece);
  }
  return run;
}

Interval extent(const Side& side) {
  Interval all = side.front().along;
  for (const Piece& piece : side) all.to = std::max(all.to, piece.along.to);
  return all;
}

double covered(const Side& side, const Interval& interval) {
  double sum = 0.0;
  double reached = interval.from;
  for (const Piece& piece : side) {
    const double to = std::min(piece.along.to, interval.to);
    sum += std::max(0.0, to - std::max(piece.along.from, reached));
    reached = std::max(reached, to);
  }
  return sum;
}

double mean_offset(const Side& side, const Interval& interval) {
  double sum = 0.0;
  double weight = 0.0;
  for (const Piece& piece : side) {
    const Interval part = common_part(piece.along, interval);
    if (part.length() <= 0.0) continue;
    sum += part.length() * piece.offset_at(0.5 * (part.from + part.to));
    weight += part.length();
  }
  return weight > 0.0 ? sum / weight : side.front().middle_offset();
}

}  // namespace perceptor::identify
