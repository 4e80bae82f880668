/// @file The ways to cut a scan into runs of beams that one line explains each: one signature,
/// chosen by configuration. What comes before (beams, gaps, moments) and after (the fit, ends,
/// corners) is the same for all.
#pragma once

#include <array>
#include <string_view>
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

/// A method, and what it is called wherever one can be chosen.
struct NamedMethod {
  std::string_view name;
  ScanMethod method;
  Method function;
};

/// Every method, the default first.
extern const std::array<NamedMethod, 5> kMethods;

Method method_of(ScanMethod method);

}  // namespace perceptor::scan
