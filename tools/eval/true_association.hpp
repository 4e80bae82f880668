/// @file The bound: the walls of an extractor that knows which beam ends on which wall. What is
/// left is the noise of the ranges, and no extractor does better on average.
#pragma once

#include "tools/eval/found_walls.hpp"
#include "tools/eval/scan_set.hpp"

namespace perceptor {

struct TrueAssociationParameters {
  double outlier_sigmas = 5.0;   ///< [-] a range further off its wall tells nothing of it
  double min_turn = 0.20943951;  ///< [rad] between two walls that make a corner, 12 degrees
  double max_reach = 0.25;       ///< [m] from the ends of both walls to their corner
};

/// For each piece that has to be found, in the order of the beams, the maximum-likelihood line
/// through its returns, for range noise that is normal and alike on all beams. It ends at the
/// feet of the piece's true ends, so that an end's error is the line's own. Corners are where
/// lines that follow each other meet. None for a piece whose returns make no line.
FoundWalls walls_by_truth(const LabelledScan& scan,
                          const TrueAssociationParameters& parameters = {});

}  // namespace perceptor
