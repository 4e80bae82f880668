/// @file Runs methods of extracting walls over a set of scans: how long each takes, what it
/// finds, and how good that is.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "components/scan/parameters.hpp"
#include "tools/eval/found_walls.hpp"
#include "tools/eval/scan_score.hpp"
#include "tools/eval/scan_set.hpp"

namespace perceptor {

struct NamedMethod {
  std::string name;
  scan::ScanMethod method;
};

struct MethodResult {
  std::string name;
  std::vector<double> times_us;    ///< one for each scan: the shortest of its runs
  std::vector<FoundWalls> found;   ///< one for each scan
  std::optional<ScanScore> score;  ///< none without truth
};

struct ScanEvaluation {
  std::vector<double> floor_us;    ///< as `times_us`, of the least that has to be done
  std::optional<ScanScore> bound;  ///< of the walls that the truth's own beams give
  std::vector<MethodResult> methods;
};

/// Runs each method `repetitions` times on each scan, the floor right before, so that all see
/// the machine in the same state. `parameters.method` is left aside. `progress` is told how many
/// runs over a scan are done; there are scans times (methods + 1).
ScanEvaluation evaluate(const ScanSet& set, const scan::ScanParameters& parameters,
                        const std::vector<NamedMethod>& methods, int repetitions,
                        const std::function<void(std::int64_t)>& progress);

}  // namespace perceptor
