/// @file Is a log complete? Source channels count seq from 0 without gaps; what is computed
/// keeps the seq of what it was computed from, so its publisher's count in STATUS is held
/// against the number of messages; STATUS itself counts from 0 with each start.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "common/log/event_log.hpp"
#include "common/time/stamp.hpp"
#include "tools/logcheck/channel_record.hpp"
#include "tools/logcheck/report.hpp"

namespace perceptor {

/// A smaller step back of the log's stamps is a burst, or a clock that was set [us].
inline constexpr std::int64_t kLargeStepBack = kMicrosecondsPerSecond;

/// Takes a log's events in the order of the file.
class LogCheck {
 public:
  void add(const LogEvent& event);

  /// Of all that came so far; the file's size and damage are not known here.
  LogReport report() const;

 private:
  /// One start of a component: what each channel held at its first STATUS.
  using Boot = std::pair<std::string, std::int64_t>;
  using Counts = std::map<std::string, std::int64_t>;

  void add_status(ChannelRecord& channel, const LogEvent& event);
  void watch_stamps(const LogEvent& event);

  std::map<std::string, ChannelRecord> channels_;
  std::map<Boot, Counts> boots_;
  std::int64_t events_ = 0;
  std::int64_t step_backs_ = 0;
  std::vector<StepBack> first_step_backs_;
  std::int64_t previous_stamp_ = 0;
  std::int64_t earliest_stamp_ = 0;
  std::int64_t latest_stamp_ = 0;
};

/// Reads the whole file; `progress` is told the bytes read so far. Throws LogError.
LogReport check_log(const std::filesystem::path& file,
                    const std::function<void(std::int64_t done, std::int64_t size)>& progress = {});

}  // namespace perceptor
