/// @file What the publishers say they sent on one channel, held against what the log has.
///
/// A component counts what it publishes since it started, and says so in each STATUS. Both go
/// through one socket, so that in a log a STATUS stands after exactly the messages that it
/// counts. What was lost between two STATUS messages is the difference of the two counts.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tools/logcheck/report.hpp"

namespace perceptor {

/// What one start of a component said of one channel.
struct Claim {
  std::string component;
  std::int64_t boot = 0;
  std::int64_t published_first = 0;  ///< at its first STATUS in the log
  std::int64_t in_log_first = 0;     ///< messages that the log held by then
  std::int64_t published_last = 0;   ///< at its last STATUS in the log
  std::int64_t in_log_last = 0;
  std::int64_t session = 0;   ///< of the last message
  std::int64_t last_seq = 0;  ///< of the last message; -1: none
  std::int64_t stamp = 0;     ///< [us] of the last STATUS in the log
  bool stopped = false;       ///< that was its last word
  std::vector<Loss> losses;

  /// Published between the first and the last STATUS and not in the log; negative: more are
  /// in the log than were published.
  std::int64_t lost() const {
    return (published_last - published_first) - (in_log_last - in_log_first);
  }
};

/// What follows from the claims of one channel.
struct ClaimedCompleteness {
  std::int64_t missing = 0;
  std::vector<Loss> losses;
  std::vector<std::string> missing_reasons;
  std::vector<std::string> unproven;  ///< empty: the count is proven
};

class PublisherClaims {
 public:
  /// `claim` says what a STATUS says: its first and its last are alike. `began` [messages]: what
  /// the log held at the component's first STATUS, where the channel was not listed yet.
  void add(const Claim& claim, bool is_first_status, std::int64_t in_log_at_first_status);

  /// Against the number of messages on the channel in the whole log.
  ClaimedCompleteness check(std::int64_t in_log) const;

  const std::vector<Claim>& claims() const { return claims_; }

 private:
  std::vector<Claim> claims_;  ///< in order of their first STATUS
  bool concurrent_ = false;    ///< two publishers took turns
};

}  // namespace perceptor
