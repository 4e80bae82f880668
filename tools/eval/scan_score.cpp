#include "tools/eval/scan_score.hpp"

#include <algorithm>
#include <cmath>

#include "tools/eval/quantile.hpp"

namespace perceptor {
namespace {

struct CornerPair {
  std::size_t truth = 0;
  std::size_t found = 0;
  double distance = 0.0;  ///< [m]
};

/// Each corner in one pair at most, the nearest pairs first.
std::vector<CornerPair> match_corners(const std::vector<TrueCorner>& truth,
                                      const std::vector<FoundCorner>& found, double radius) {
  std::vector<CornerPair> near;
  for (std::size_t t = 0; t < truth.size(); ++t)
    for (std::size_t f = 0; f < found.size(); ++f)
      if (const double apart = distance(truth[t].location, found[f].location); apart < radius)
        near.push_back({t, f, apart});
  std::ranges::stable_sort(near, {}, &CornerPair::distance);

  std::vector<CornerPair> pairs;
  for (const CornerPair& pair : near) {
    const bool is_taken = std::ranges::any_of(pairs, [&](const CornerPair& taken) {
      return taken.truth == pair.truth || taken.found == pair.found;
    });
    if (!is_taken) pairs.push_back(pair);
  }
  return pairs;
}

double root_mean(double squares, std::int64_t count) {
  return count > 0 ? std::sqrt(squares / static_cast<double>(count)) : 0.0;
}

}  // namespace

void ScanScorer::take(const LabelledScan& truth, const FoundWalls& found) {
  take_walls(truth, found.walls);
  take_corners(truth, found.corners);
}

void ScanScorer::take_walls(const LabelledScan& truth, const std::vector<Segment>& walls) {
  const WallMatching matching = match_walls(truth.pieces, walls, parameters_.walls);
  for (const WallVerdict verdict : matching.verdicts) {
    counts_.walls += verdict != WallVerdict::neutral ? 1 : 0;
    counts_.fragments += verdict == WallVerdict::fragment ? 1 : 0;
    counts_.false_walls +=
        verdict == WallVerdict::fragment || verdict == WallVerdict::nothing ? 1 : 0;
  }
  for (std::size_t p = 0; p < truth.pieces.size(); ++p) {
    const TruePiece& piece = truth.pieces[p];
    if (!piece.has_to_be_found) continue;
    ++counts_.pieces;
    if (!matching.wall_of_pieces[p]) continue;
    ++counts_.pieces_found;
    const Segment& wall = walls[*matching.wall_of_pieces[p]];
    const double angle_error = smallest_relative_angle(wall, piece.segment);
    const double offset = signed_distance(wall, middle(piece.segment));
    angle_squares_ += angle_error * angle_error;
    offset_squares_ += offset * offset;
  }
  take_ends(truth, walls, matching);
}

void ScanScorer::take_ends(const LabelledScan& truth, const std::vector<Segment>& walls,
                           const WallMatching& matching) {
  for (std::size_t w = 0; w < walls.size(); ++w) {
    if (matching.verdicts[w] != WallVerdict::matched) continue;
    // A wall over several pieces of an edge ends where the outermost two do.
    std::vector<Vector2> ends;
    for (std::size_t p = 0; p < truth.pieces.size(); ++p)
      if (matching.wall_of_pieces[p] == w) {
        ends.push_back(truth.pieces[p].segment.a);
        ends.push_back(truth.pieces[p].segment.b);
      }
    const Vector2 along = direction(walls[w]);
    const auto [first, last] =
        std::ranges::minmax_element(ends, {}, [&](const Vector2& end) { return end.dot(along); });
    end_errors_.push_back(distance(walls[w].a, *first));
    end_errors_.push_back(distance(walls[w].b, *last));
  }
}

void ScanScorer::take_corners(const LabelledScan& truth, const std::vector<FoundCorner>& corners) {
  const auto pairs = match_corners(truth.corners, corners, parameters_.corner_radius);
  counts_.corners += std::ranges::count_if(truth.corners, &TrueCorner::has_to_be_found);
  counts_.corner_claims += static_cast<std::int64_t>(corners.size());
  counts_.corner_matches += static_cast<std::int64_t>(pairs.size());
  counts_.false_corners += static_cast<std::int64_t>(corners.size() - pairs.size());
  for (const auto& [t, f, apart] : pairs) {
    counts_.corner_mix_ups += truth.corners[t].is_convex != corners[f].is_convex ? 1 : 0;
    if (!truth.corners[t].has_to_be_found) continue;
    ++counts_.corners_found;
    corner_errors_.push_back(apart);
  }
}

ScanScore ScanScorer::score() const {
  ScanScore score = counts_;
  score.angle_rms = root_mean(angle_squares_, counts_.pieces_found);
  score.offset_rms = root_mean(offset_squares_, counts_.pieces_found);
  score.end_median = quantile(end_errors_, 0.5);
  score.corner_median = quantile(corner_errors_, 0.5);
  return score;
}

}  // namespace perceptor
