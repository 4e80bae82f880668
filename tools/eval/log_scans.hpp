/// @file The laser scans of an LCM event log, as a set of single scans without truth.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "common/log/event_log.hpp"
#include "tools/eval/scan_set.hpp"

namespace perceptor {

struct LogScans {
  ScanSet set;                    ///< in log order; scans may differ in their beams
  std::int64_t undecodable = 0;   ///< laser messages left out
  std::string first_fault;        ///< why the first of them was
  std::vector<LogDamage> damage;  ///< stretches of the file that held no event
};

/// Every good PICO_LASER message becomes a scan. Its id is the message's place among all laser
/// messages of the log, from 0: that of a complete log of one session is the message's `seq`,
/// and it stays unique where a log holds several sessions. `time` is utime in seconds, the scan
/// is as the scan component gets it, irregular bearings and the laser's pose included.
/// `progress` is told how many bytes are read. Throws LogError
/// where the log cannot be read, or holds no good laser message.
LogScans read_log_scans(const std::filesystem::path& log,
                        const std::function<void(std::int64_t)>& progress);

}  // namespace perceptor
