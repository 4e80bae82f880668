/// @file An evaluation on single scans as text: the table for people, the walls for programs.
#pragma once

#include <string>
#include <string_view>

#include "tools/eval/scan_evaluation.hpp"

namespace perceptor {

/// What the table's columns mean, for --help.
extern const std::string_view kScanColumns;

/// A row for the bound, the floor and each method; without truth with counts for scores.
std::string scan_table(const ScanEvaluation& evaluation);

/// A line "E id x1 y1 x2 y2" for each wall and "C id x y kind" for each corner, in metres in the
/// frame of the laser at scan `id`, kind 1 convex and -1 concave. Before each of several methods
/// "# method NAME".
std::string scan_dump(const ScanSet& set, const ScanEvaluation& evaluation);

}  // namespace perceptor
