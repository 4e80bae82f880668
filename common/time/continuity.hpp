/// @file Does a channel go on, or did it begin anew?
#pragma once

#include <cstdint>
#include <optional>

#include "common/time/stamp.hpp"

namespace perceptor {

enum class Continuity {
  continues,
  began_anew,    ///< first message, new session, or time stepped back by more than 2 s
  stepped_back,  ///< a smaller step back: to be dropped
  repeated,      ///< the utime of the message before: to be dropped
};

/// Watches the stamps of one channel, in the order in which they arrive.
class ContinuityWatch {
 public:
  /// A larger step back means that the robot or the log began anew [us].
  static constexpr std::int64_t kRestartStep = 2 * kMicrosecondsPerSecond;

  Continuity check(const Stamp& stamp);

  /// Times that the channel began anew, the first message not counted.
  std::int64_t restarts() const { return restarts_; }

  /// Sequence numbers that never came, within sessions.
  std::int64_t missed() const { return missed_; }

 private:
  std::optional<Stamp> last_;
  std::int64_t restarts_ = 0;
  std::int64_t missed_ = 0;
};

}  // namespace perceptor
