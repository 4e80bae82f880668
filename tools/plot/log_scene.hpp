/// @file The scene that a log shows at one moment.
#pragma once

#include <filesystem>
#include <limits>

#include "components/viewer/newest.hpp"

namespace perceptor {

struct LogScene {
  viewer::Scene scene;
  double seconds = 0.0;       ///< [s] from the log's first event to the last that was taken
  std::int64_t rejected = 0;  ///< messages that were turned down
};

/// After all events up to `at` [s] after the first, by the log's own stamps, as lcm-logplayer
/// plays them; without `at` after all. Shows its progress. Throws LogError where the log cannot be
/// read or is empty.
LogScene scene_of_log(const std::filesystem::path& log,
                      double at = std::numeric_limits<double>::infinity());

}  // namespace perceptor
