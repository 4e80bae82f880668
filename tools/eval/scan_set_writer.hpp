/// @file Writes sets of labelled scans as text, in the lxscan format, version 1.
#pragma once

#include <filesystem>
#include <ostream>

#include "tools/eval/scan_set.hpp"

namespace perceptor {

/// Angles to 1 nrad (the heading: 1 urad), places to 10 um, ranges to 0.1 mm; what is no return
/// becomes 0. Throws std::invalid_argument where the scans do not share one laser with evenly
/// spaced beams, which one header line describes, or where there are none.
void write_scans(std::ostream& out, const ScanSet& set);

/// Pieces, corners and doors, scan by scan, to 10 um.
void write_truth(std::ostream& out, const ScanSet& set);

/// The file of the truth beside that of the scans: .truth in place of .scan. Throws
/// std::invalid_argument where the name does not end in .scan.
std::filesystem::path truth_path(const std::filesystem::path& scan_path);

/// Both files; the one of the truth only where the set has it. Throws std::runtime_error where a
/// file cannot be written, and as the two above.
void write_scan_set(const ScanSet& set, const std::filesystem::path& scan_path);

}  // namespace perceptor
