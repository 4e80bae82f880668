/// @file Which beams of a run support its line, and the line that these give.
#pragma once

#include <cstddef>

#include "components/scan/runs.hpp"

namespace perceptor::scan {

/// The beams of a run that support a line.
struct Support {
  std::size_t first = 0;  ///< index into Beams
  std::size_t last = 0;   ///< inclusive
  int count = 0;
  Moments moments;
  Vector2 sum{0.0, 0.0};  ///< [m] of where they end, from the laser
};

/// A line, and the beams it is the best line of.
struct SupportedLine {
  PolarLine line;
  Support support;
  double excess = 1.0;  ///< [-] their variance about the line over what the noise says, at least 1
};

/// Fits a line to the run's beams and drops those too far from it, again and again until they
/// stay the same. Where fewer than `min_beams` are left, it stops there.
SupportedLine fit_supported_line(const Run& run, const Sweep& sweep,
                                 const ScanParameters& parameters);

}  // namespace perceptor::scan
