/// @file The extraction of walls from single scans, scored against the truth.
#pragma once

#include <cstdint>
#include <vector>

#include "tools/eval/found_walls.hpp"
#include "tools/eval/scan_set.hpp"
#include "tools/eval/wall_matching.hpp"

namespace perceptor {

struct ScanScoreParameters {
  WallMatchParameters walls;
  double corner_radius = 0.15;  ///< [m] within which a found corner matches a true one
};

/// Over all scans. "To be found" are the pieces and corners whose has_to_be_found is set; what
/// was found of the others counts neither way.
struct ScanScore {
  std::int64_t pieces = 0;        ///< to be found
  std::int64_t pieces_found = 0;  ///< of those
  std::int64_t walls = 0;         ///< found, the neutral ones not counted
  std::int64_t false_walls = 0;   ///< of those: nothing and fragments
  std::int64_t fragments = 0;     ///< of those: lie on a wall that another is the match of
  double angle_rms = 0.0;         ///< [rad] of the pieces found
  double offset_rms = 0.0;        ///< [m] the same, across the wall at the piece's middle
  double end_median = 0.0;        ///< [m] between the ends of walls and of the pieces they match

  std::int64_t corners = 0;         ///< to be found
  std::int64_t corners_found = 0;   ///< of those
  std::int64_t corner_claims = 0;   ///< found at all
  std::int64_t false_corners = 0;   ///< of those: at no true corner, or at one that has another
  std::int64_t corner_matches = 0;  ///< of those: at a true corner, to be found or not
  std::int64_t corner_mix_ups = 0;  ///< of those: convex taken for concave or the reverse
  double corner_median = 0.0;       ///< [m] of the corners to be found that were
};

/// Collects over many scans.
class ScanScorer {
 public:
  explicit ScanScorer(const ScanScoreParameters& parameters = {}) : parameters_(parameters) {}

  void take(const LabelledScan& truth, const FoundWalls& found);

  ScanScore score() const;

 private:
  void take_walls(const LabelledScan& truth, const std::vector<Segment>& walls);
  void take_ends(const LabelledScan& truth, const std::vector<Segment>& walls,
                 const WallMatching& matching);
  void take_corners(const LabelledScan& truth, const std::vector<FoundCorner>& corners);

  ScanScoreParameters parameters_;
  ScanScore counts_;
  double angle_squares_ = 0.0;         // [rad^2]
  double offset_squares_ = 0.0;        // [m^2]
  std::vector<double> end_errors_;     // [m]
  std::vector<double> corner_errors_;  // [m]
};

}  // namespace perceptor
