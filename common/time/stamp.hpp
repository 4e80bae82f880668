/// @file When and in which session something was measured.
#pragma once

#include <cstdint>

namespace perceptor {

inline constexpr std::int64_t kMicrosecondsPerSecond = 1'000'000;

/// What every data message begins with. What is computed from a measurement copies it.
struct Stamp {
  std::int64_t utime = 0;    ///< [us] when the measurement was taken
  std::int64_t session = 0;  ///< chosen by the source when it starts
  std::int64_t seq = 0;      ///< counted by the source on its channel

  friend bool operator==(const Stamp&, const Stamp&) = default;
};

/// [s] from one utime to another.
constexpr double seconds_between(std::int64_t from_utime, std::int64_t to_utime) {
  return static_cast<double>(to_utime - from_utime) / static_cast<double>(kMicrosecondsPerSecond);
}

/// The stamp of a data message.
template <class Message>
Stamp stamp_of(const Message& message) {
  return {message.utime, message.session, message.seq};
}

/// Gives a data message the stamp of the measurement it was computed from.
template <class Message>
void set_stamp(Message& message, const Stamp& stamp) {
  message.utime = stamp.utime;
  message.session = stamp.session;
  message.seq = stamp.seq;
}

}  // namespace perceptor
