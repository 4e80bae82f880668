/// @file What pico-eval scan works on: the scans of a file, the configuration, the methods.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "common/runner/runner.hpp"
#include "components/scan/scan_config.hpp"
#include "tools/eval/scan_evaluation.hpp"
#include "tools/eval/scan_set.hpp"

namespace perceptor {

struct ScanInput {
  std::filesystem::path scans;  ///< an lxscan text file or an LCM event log, by content
  std::filesystem::path truth;  ///< empty: the one beside the scans
  std::filesystem::path config = default_config_directory() / "scan.json";
  std::vector<std::string> overrides;
  std::vector<std::string> methods;  ///< empty: the configuration's
};

/// As pico-scan reads it, robot.json included. Throws config::Error.
ScanConfig read_scan_config(const ScanInput& input);

/// Says on standard error what of a log it could not read. Scans of a log come from a robot that
/// sees itself, so that the set of one has the robot's footprint. Throws TextFileError, LogError,
/// and config::Error where truth is given for a log.
ScanSet read_scan_set(const ScanInput& input, const Robot& robot);

/// Throws config::Error for a name that is no method's. Never empty.
std::vector<NamedMethod> chosen_methods(const std::vector<std::string>& names,
                                        scan::ScanMethod configured);

}  // namespace perceptor
