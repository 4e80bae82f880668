/// @file What was seen on one channel of a log, and what follows from it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "common/log/event_log.hpp"
#include "tools/logcheck/publisher_claims.hpp"
#include "tools/logcheck/report.hpp"
#include "tools/logcheck/seq_set.hpp"

namespace perceptor {

/// The messages of one session; on a STATUS channel, of one start of the component.
struct SessionRecord {
  std::int64_t session = 0;
  std::int64_t count = 0;
  std::int64_t repeated = 0;
  SeqSet seqs;
  bool stopped = false;  ///< of STATUS: the last word came
};

struct ChannelRecord {
  std::int64_t count = 0;
  std::int64_t delivered_twice = 0;  ///< of those: the network may do that to a datagram
  std::deque<std::size_t> recent;    ///< hashes of the last payloads
  std::int64_t first_stamp = 0;      ///< [us]
  std::int64_t last_stamp = 0;       ///< [us]
  std::map<std::string, std::int64_t> undecodable;
  std::vector<SessionRecord> sessions;                ///< in order of appearance
  std::map<std::int64_t, std::size_t> session_index;  ///< session -> index into sessions
  PublisherClaims publishers;

  /// Counts a message, whatever it is.
  void count_message(const LogEvent& event);

  /// As their publisher counts them.
  std::int64_t sent() const { return count - delivered_twice; }

  /// Adds a message that could be decoded; gives its session.
  SessionRecord& add(std::int64_t session, std::int64_t seq);
};

/// How completeness of a channel can be known.
enum class ChannelKind {
  source,    ///< seq counts from 0 without gaps within a session
  computed,  ///< seq is that of the measurement: only its publisher's count can tell
  status,    ///< seq counts from 0 without gaps with each start of the component
  internal,  ///< LCM's own
  foreign,   ///< none of ours
};

ChannelKind kind_of(std::string_view channel);

ChannelReport report_of(const std::string& channel, const ChannelRecord& record);

}  // namespace perceptor
