/// @file What a recorded run shows: messages, latency, and what was found against the truth.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/log/event_log.hpp"
#include "tools/eval/world_score.hpp"

namespace perceptor {

/// Of one number over many messages [ms].
struct Spread {
  double median = 0.0;
  double p99 = 0.0;
};

/// From a scan's arrival in the log to that of its identified map. Only a log recorded live
/// knows: in a replayed one all three are zero.
struct Latency {
  std::size_t maps = 0;
  Spread total;
  Spread waiting;    ///< for the odometry that brackets the scan
  Spread computing;  ///< the rest: four processes and as many hops
};

class RunSummary {
 public:
  void take(const LogEvent& event);

  const std::map<std::string, std::int64_t>& messages() const { return messages_; }
  std::int64_t undecodable() const { return undecodable_; }
  Latency latency() const;

  /// None where the log holds no truth.
  std::optional<WorldScore> score() const;

 private:
  using Key = std::pair<std::int64_t, std::int64_t>;  ///< session, seq
  struct Times {
    std::int64_t utime;
    std::int64_t arrival;
  };

  std::map<std::string, std::int64_t> messages_;
  std::int64_t undecodable_ = 0;
  std::map<Key, Times> scans_;
  std::map<std::int64_t, std::vector<Times>> positions_;  ///< by session
  std::vector<std::pair<Key, std::int64_t>> identified_;  ///< and when each arrived
  WorldScorer scorer_;
};

}  // namespace perceptor
