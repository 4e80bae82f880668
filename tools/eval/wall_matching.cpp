#include "tools/eval/wall_matching.hpp"

#include <algorithm>
#include <cmath>

namespace perceptor {
namespace {

/// A wall that lies on a piece.
struct Pair {
  std::size_t wall = 0;
  std::size_t piece = 0;
  double overlap = 0.0;  ///< [m] of the piece that the wall covers
};

/// How much of the first lies beside the second [m], along the first.
double overlap(const Segment& first, const Segment& second) {
  const auto [begin, end] = projected_interval(first, second);
  return std::max(0.0, std::min(end, length(first)) - std::max(begin, 0.0));
}

bool runs_along(const Segment& wall, const Segment& piece, const WallMatchParameters& parameters) {
  return smallest_relative_angle(wall, piece) < parameters.max_angle &&
         std::abs(signed_distance(wall, middle(piece))) < parameters.max_offset;
}

/// Of the wall, with all pieces of the edge together [m].
double overlap_with_edge(const Segment& wall, const std::vector<TruePiece>& pieces, int edge) {
  double sum = 0.0;
  for (const TruePiece& piece : pieces)
    if (piece.edge == edge) sum += overlap(wall, piece.segment);
  return sum;
}

std::vector<Pair> lying_pairs(const std::vector<TruePiece>& pieces,
                              const std::vector<Segment>& walls,
                              const WallMatchParameters& parameters) {
  std::vector<Pair> pairs;
  for (std::size_t w = 0; w < walls.size(); ++w) {
    if (length(walls[w]) <= 0.0) continue;
    const double least = parameters.min_share_of_wall * length(walls[w]);
    for (std::size_t p = 0; p < pieces.size(); ++p) {
      const Segment& piece = pieces[p].segment;
      const double covered = overlap(piece, walls[w]);
      if (covered > 0.0 && runs_along(walls[w], piece, parameters) &&
          overlap_with_edge(walls[w], pieces, pieces[p].edge) >= least)
        pairs.push_back({w, p, covered});
    }
  }
  std::ranges::stable_sort(pairs, std::ranges::greater{}, &Pair::overlap);
  return pairs;
}

}  // namespace

WallMatching match_walls(const std::vector<TruePiece>& pieces, const std::vector<Segment>& walls,
                         const WallMatchParameters& parameters) {
  WallMatching matching;
  matching.verdicts.assign(walls.size(), WallVerdict::nothing);
  matching.wall_of_pieces.assign(pieces.size(), std::nullopt);
  const std::vector<Pair> pairs = lying_pairs(pieces, walls, parameters);

  std::vector<std::optional<int>> edge_of_walls(walls.size());
  for (const auto& [w, p, covered] : pairs) {
    const TruePiece& piece = pieces[p];
    const bool covers = covered >= parameters.min_share_of_piece * length(piece.segment);
    const bool is_on_its_edge = !edge_of_walls[w] || edge_of_walls[w] == piece.edge;
    if (!covers || !is_on_its_edge || matching.wall_of_pieces[p]) continue;
    matching.wall_of_pieces[p] = w;
    edge_of_walls[w] = piece.edge;
    WallVerdict& verdict = matching.verdicts[w];
    if (verdict != WallVerdict::matched)
      verdict = piece.has_to_be_found ? WallVerdict::matched : WallVerdict::neutral;
  }
  // The longest overlap comes first, and decides.
  for (const auto& [w, p, covered] : pairs)
    if (matching.verdicts[w] == WallVerdict::nothing)
      matching.verdicts[w] =
          pieces[p].has_to_be_found ? WallVerdict::fragment : WallVerdict::neutral;
  return matching;
}

}  // namespace perceptor
