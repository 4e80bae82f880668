/// @file The scene that a log shows at one moment.
#pragma once

#include <filesystem>
#include <limits>

#include "components/viewer/newest.hpp"

namespace perceptor {

struct LogScene {
  viewer::Scene scene;
  double seconds = 0.0;       ///< [s] of robot time, from the first measurement to the last
  std::int64_t rejected = 0;  ///< messages that were turned down
};

/// After all events up to `at` [s] of robot time after the first measurement; without `at` after
/// all. The log's own stamps do not count: a simulator that ran faster than real time wrote them.
/// Shows its progress. Throws LogError where the log cannot be read or holds no measurement.
LogScene scene_of_log(const std::filesystem::path& log,
                      double at = std::numeric_limits<double>::infinity());

}  // namespace perceptor
