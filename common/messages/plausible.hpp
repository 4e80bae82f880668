/// @file What a number of a message may be, for the functions of validate.hpp. Wide bounds:
/// inside them nothing overflows, and no real robot is outside.
#pragma once

#include <cmath>
#include <cstdint>
#include <string_view>

#include <pico/pose_t.hpp>

namespace perceptor::messages {

inline constexpr double kMaxCoordinate = 1e6;          ///< [m] from the origin of any frame
inline constexpr double kMaxAngle = 1000.0;            ///< [rad] before it is wrapped
inline constexpr double kMaxSpeed = 1000.0;            ///< [m/s], [rad/s]
inline constexpr double kMaxDeviation = 1e6;           ///< covariances reach its square
inline constexpr std::int64_t kMaxTime = 1LL << 60U;   ///< [us] some 36 000 years
inline constexpr std::int64_t kMaxCount = 1LL << 60U;  ///< of sequence numbers too

// NaN is within no bounds.
inline bool is_coordinate(double value) { return std::abs(value) <= kMaxCoordinate; }
inline bool is_angle(double value) { return std::abs(value) <= kMaxAngle; }
inline bool is_speed(double value) { return std::abs(value) <= kMaxSpeed; }
inline bool is_length(double value) { return value >= 0.0 && value <= kMaxCoordinate; }
inline bool is_ratio(double value) { return value >= 0.0 && value <= 1.0; }
inline bool is_not_negative(double value) { return std::isfinite(value) && value >= 0.0; }
inline bool is_utime(std::int64_t value) { return value >= 0 && value <= kMaxTime; }
inline bool is_count(std::int64_t value) { return value >= 0 && value <= kMaxCount; }

inline bool is_pose(const pico::pose_t& pose) {
  return is_coordinate(pose.x) && is_coordinate(pose.y) && is_angle(pose.a);
}

/// Of two numbers: symmetric, and no combination of them has a negative variance. Rounding is
/// forgiven, because a covariance that was rotated may be as thin as a line.
inline bool is_covariance(double xx, double xy, double yy) {
  constexpr double largest = kMaxDeviation * kMaxDeviation;
  constexpr double rounding = 1e-9;
  if (!is_not_negative(xx) || !is_not_negative(yy) || !std::isfinite(xy)) return false;
  const double trace = xx + yy;
  return trace <= largest && xy * xy <= xx * yy + rounding * trace * trace;
}

/// The first three fields of every message but STATUS.
template <class Message>
std::string_view fault_of_stamp(const Message& message) {
  if (!is_utime(message.utime)) return "utime out of range";
  if (!is_count(message.seq)) return "sequence number out of range";
  return {};
}

}  // namespace perceptor::messages
