/// @file What is known about a log's completeness.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "common/log/event_log.hpp"
#include "tools/logcheck/seq_set.hpp"

namespace perceptor {

enum class Verdict {
  complete,      ///< proven: everything that was published is there
  not_checked,   ///< LCM's own traffic, of no interest
  not_provable,  ///< nothing is known to be missing, but nobody says that nothing is
  missing,       ///< something that was published is not there
  damaged,       ///< a message is there that cannot be decoded
};

std::string_view to_string(Verdict verdict);

/// Messages that must have been lost between two STATUS messages of their publisher.
struct Loss {
  std::int64_t count = 0;
  std::int64_t from = 0;  ///< [us] stamp of the log at the STATUS before
  std::int64_t to = 0;    ///< [us] stamp of the log at the STATUS after
};

/// The messages of one session of a data channel, or of one start of a component on its
/// STATUS channel.
struct SessionReport {
  std::int64_t session = 0;  ///< for STATUS: boot
  std::int64_t count = 0;
  std::int64_t first_seq = 0;
  std::int64_t last_seq = 0;
  std::int64_t repeated = 0;      ///< of a source or STATUS: came with a seq that was there
  std::vector<SeqRange> missing;  ///< of a source or STATUS; others may leave numbers out
};

struct ChannelReport {
  std::string channel;
  Verdict verdict = Verdict::complete;
  std::int64_t count = 0;    ///< messages in the log, undecodable ones included
  std::int64_t missing = 0;  ///< messages that were published and are not there
  double rate = 0.0;         ///< [Hz] over the log's stamps; 0: fewer than two messages
  std::map<std::string, std::int64_t> undecodable;  ///< by what is wrong with them
  std::vector<SessionReport> sessions;              ///< in order of appearance
  std::vector<Loss> losses;                         ///< where `missing` is known by count
  std::vector<std::string> reasons;                 ///< for people: why it is not complete
};

/// The log's stamps went back by more than bursts explain.
struct StepBack {
  std::int64_t event = 0;  ///< counted from 0 in the file
  std::int64_t from = 0;   ///< [us]
  std::int64_t to = 0;     ///< [us]
};

struct LogReport {
  std::int64_t events = 0;
  std::int64_t size = 0;  ///< [bytes] of the file
  double duration = 0.0;  ///< [s] from the earliest stamp to the latest
  std::vector<LogDamage> damage;
  std::int64_t step_backs = 0;
  std::vector<StepBack> first_step_backs;
  std::vector<ChannelReport> channels;  ///< by name

  /// Of all channels and of the file; an empty log proves nothing.
  Verdict verdict() const;
};

/// 0 complete, 1 missing or damaged, 3 not provable.
int exit_code(const LogReport& report);

/// A table and what is to be said of it, for people.
void print(std::ostream& out, const LogReport& report);

/// The same for programs.
std::string to_json(const LogReport& report);

}  // namespace perceptor
