/// @file Does a channel go on, or did it begin anew?
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "common/time/stamp.hpp"

namespace perceptor {

enum class Continuity {
  continues,
  began_anew,    ///< first message, new session, or time stepped back by more than 2 s
  stepped_back,  ///< a smaller step back: to be dropped
  repeated,      ///< the utime of the message before: to be dropped
};

/// Why a message is dropped, as a fixed text that is counted; empty: it is not.
std::string_view order_fault(Continuity continuity);

/// Which sequence numbers of a session came. What comes late, or twice, is told from what never
/// came by a window over the last 64 (as against replay in IPsec: RFC 4303, section 3.4.3).
class SequenceWindow {
 public:
  explicit SequenceWindow(std::int64_t first) : highest_(first) {}

  /// Gives how many more numbers are missing than before: negative where one comes late.
  std::int64_t take(std::int64_t seq);

 private:
  std::int64_t highest_;
  std::uint64_t came_ = ~std::uint64_t{0};  ///< bit i: highest_ - i; what was before the first
                                            ///< is not missing
};

/// Watches the stamps of one channel, in the order in which they arrive.
class ContinuityWatch {
 public:
  /// A larger step back means that the robot or the log began anew [us].
  static constexpr std::int64_t kRestartStep = 2 * kMicrosecondsPerSecond;

  /// No more are counted as missed, however far a sender's numbers leap.
  static constexpr std::int64_t kMostMissed = std::int64_t{1} << 60U;

  /// A session that is back after fewer messages of another one: both are there at once.
  static constexpr int kTurn = 50;

  Continuity check(const Stamp& stamp);

  /// Times that the channel began anew, the first message not counted.
  std::int64_t restarts() const { return restarts_; }

  /// Sequence numbers that never came, within sessions.
  std::int64_t missed() const { return missed_; }

  /// Two sources take turns on the channel, so that it begins anew all the time.
  bool is_contested() const { return is_contested_; }

 private:
  void begin(const Stamp& stamp);

  std::optional<Stamp> last_;
  SequenceWindow window_{0};
  std::int64_t restarts_ = 0;
  std::int64_t missed_ = 0;
  std::optional<std::int64_t> session_before_;
  int in_session_ = 0;  ///< messages, up to kTurn
  bool is_contested_ = false;
};

}  // namespace perceptor
