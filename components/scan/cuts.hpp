/// @file Where exactly one wall ends and the next begins.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "components/scan/runs.hpp"

namespace perceptor::scan {

/// Memory that is worked in, kept from scan to scan.
struct CutMemory {
  std::vector<PolarLine> lines;
  std::vector<std::optional<std::size_t>> cuts;
};

/// Moves each cut between neighbours that adjoin to the bearing at which their lines cross; where
/// they cross elsewhere, as those of a step in a wall, to where the beams fit best.
void place_cuts(std::vector<Run>& runs, const Sweep& sweep, CutMemory& memory);

/// Gives the beams of a short run to the neighbours on both sides of it, where their two lines
/// explain them as well as three would: what is left at a corner that was first cut beside it.
void dissolve_short(std::vector<Run>& runs, const Sweep& sweep, const ScanParameters& parameters);

}  // namespace perceptor::scan
