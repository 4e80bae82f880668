/// @file Every event of a log, with a progress bar.
#pragma once

#include <filesystem>
#include <functional>

#include "common/log/event_log.hpp"

namespace perceptor {

/// Says on standard error what of the file is damaged. Throws LogError where it cannot be read.
void read_events(const std::filesystem::path& log,
                 const std::function<void(const LogEvent&)>& take);

}  // namespace perceptor
