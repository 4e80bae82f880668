/// @file Runs of beams that one straight wall explains: cut at gaps, made exact, merged. What
/// all methods share before and after they look for corners.
#pragma once

#include <vector>

#include "components/scan/line_fit.hpp"

namespace perceptor::scan {

/// Consecutive beams, begin to end - 1; end may pass the seam of a circle.
struct Run {
  std::size_t begin = 0;
  std::size_t end = 0;
  std::size_t solid_until = 0;  ///< the first stray that was bridged; end: none
  std::size_t solid_from = 0;   ///< after the last stray that was bridged; begin: none
  Moments moments;              ///< of its beams, without the strays

  std::size_t size() const { return end - begin; }
};

/// A run of these beams, all of them counted.
Run make_run(const PrefixMoments& sums, std::size_t begin, std::size_t end);

/// Cut wherever the wall cannot go on.
std::vector<Run> split_at_gaps(const Beams& beams, const PrefixMoments& sums);

/// Whether two lines explain the beams no better than one: chi-square rises by less than
/// `merge_chi2`, and what real surfaces bend by, when both share a line.
bool one_line_explains(const Moments& first, const Moments& second,
                       const ScanParameters& parameters);

/// Whether the second run begins where the first ends, a few strays apart, without a gap.
bool adjoin(const Beams& beams, const Run& first, const Run& second);

/// The same run, one turn later.
Run past_seam(Run run, const Beams& beams);

/// Makes of roughly cut runs those that one line explains each: cuts where a run is bent,
/// moves each cut between neighbours to where two lines fit best, and merges neighbours that
/// one line explains. In a circle this holds for the last run and the first, too.
std::vector<Run> refine(std::vector<Run> runs, const Beams& beams, const PrefixMoments& sums,
                        const ScanParameters& parameters);

}  // namespace perceptor::scan
