/// @file Short runs that stand for nothing.
#pragma once

#include <vector>

#include "components/scan/runs.hpp"

namespace perceptor::scan {

/// Gives the beams of a short run to the neighbours on both sides of it, where their two lines
/// explain them as well as three would: what is left at a corner that was first cut beside it.
/// `losses` is working memory.
void dissolve_short(std::vector<Run>& runs, const Sweep& sweep, const ScanParameters& parameters,
                    std::vector<double>& losses);

}  // namespace perceptor::scan
