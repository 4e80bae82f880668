/// @file Where exactly one wall ends and the next begins.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "components/scan/runs.hpp"

namespace perceptor::scan {

/// The beams, first to last, between which a cut may be moved.
struct Window {
  std::size_t first;
  std::size_t last;
};

/// The cut of the window with the least squared distances of the beams from their lines.
std::size_t best_fit(const PolarLine& before, const PolarLine& after, const Window& window,
                     const Beams& beams);

/// Whether the beams between two places of a cut, that of the lines' crossing and that which fits,
/// tell them apart: they passed between the end of one wall and another close behind it, and the
/// lines cross where no wall is. `excess`: variance of the beams about their lines over what the
/// noise says, >= 1.
bool pass_by(const PolarLine& before, const PolarLine& after, std::size_t crossing,
             std::size_t fitting, double excess, const Beams& beams);

/// A run's line, and how well it explains the beams.
struct FittedRun {
  PolarLine line;
  double excess = 1.0;    ///< variance of the beams over what the noise says, >= 1
  bool is_mixed = false;  ///< beams of another wall seem to be among them
};

/// Memory that is worked in, kept from scan to scan.
struct CutMemory {
  std::vector<FittedRun> fits;
  std::vector<std::optional<std::size_t>> cuts;
};

/// Moves each cut between neighbours that adjoin to the bearing at which their lines cross; where
/// they cross elsewhere, as those of a step in a wall or of a cabinet close before one, to where
/// the beams fit best.
void place_cuts(std::vector<Run>& runs, const Sweep& sweep, CutMemory& memory);

}  // namespace perceptor::scan
