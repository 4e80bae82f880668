/// @file The ways to cut a scan into runs of beams that one line explains each: one signature,
/// chosen by configuration. What comes before (beams, gaps, moments) and after (the fit, ends,
/// corners) is the same for all.
#pragma once

#include <vector>

#include "components/scan/cuts.hpp"
#include "components/scan/resample.hpp"
#include "components/scan/runs.hpp"

namespace perceptor::scan {

/// Memory that the methods work in, kept from scan to scan.
struct Workspace {
  std::vector<Run> open;
  std::vector<double> gains;
  CutMemory cuts;
  std::vector<ResampledPoint> points;
};

/// Appends the runs of a sweep to `runs`, which is empty before: in order, none overlapping; in a
/// circle the last may pass the seam.
using Method = void (*)(const Sweep& sweep, const ScanParameters& parameters, Workspace& workspace,
                        std::vector<Run>& runs);

Method method_of(ScanMethod method);

}  // namespace perceptor::scan
