/// @file Makes one run of neighbours that one line explains.
#pragma once

#include <vector>

#include "components/scan/runs.hpp"

namespace perceptor::scan {

/// Merges neighbours, over strays and small holes too, until none are left that one line
/// explains. Of pairs that share a run the one goes first that loses least, so that the result
/// is the same from left to right and from right to left. `gains` is working memory.
void merge_neighbours(std::vector<Run>& runs, const Beams& beams, const ScanParameters& parameters,
                      std::vector<double>& gains);

/// All of it: merges neighbours, takes out runs of a few beams, which then count as strays, and
/// merges over these.
void merge_over_strays(std::vector<Run>& runs, const Beams& beams, const ScanParameters& parameters,
                       std::vector<double>& gains);

}  // namespace perceptor::scan
