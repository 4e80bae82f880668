/// @file What became of the beams of one scan, as text for people: which limit a wall that was
/// not found fell short of, and the configuration key of that limit.
#pragma once

#include <cstddef>
#include <string>

#include "components/scan/parameters.hpp"
#include "tools/eval/scan_findings.hpp"

namespace perceptor {

/// A line for each group of beams that share a fate, in the order of measurement; then a line for
/// each run of beams, by bearing.
std::string explain_scan(const ScanFindings& findings, const scan::ScanParameters& parameters);

/// Some sentences about one beam of the scan, and about the run that it is one of.
std::string explain_beam(const ScanFindings& findings, std::size_t beam,
                         const scan::ScanParameters& parameters);

/// The beam whose bearing [rad] is nearest, once around or not; the first of equals. The scan has
/// beams.
std::size_t nearest_beam(const LaserScan& scan, double bearing);

}  // namespace perceptor
