/// @file Pairs what was measured at T with the robot's position at T: the only place that
/// pairs, waits or drops.
///
/// Positions come in segments: runs of one session and one zero frame, within which time
/// only goes forward. An item waits until its segment brackets it, or is dropped when that
/// cannot happen any more. Both decisions follow from the two sequences alone, not from how
/// they are interleaved, as long as no buffer overflows.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string_view>
#include <utility>

#include "common/geometry/position.hpp"
#include "common/time/stamp.hpp"

namespace perceptor {

struct AlignerParameters {
  double max_gap = 0.5;            ///< [s] wider brackets are not trusted
  double max_extrapolation = 0.0;  ///< [s] pair without waiting up to this far ahead; then
                                   ///< results depend on arrival, and STATUS says so
  int max_items = 100;             ///< waiting for their bracket; beyond it the oldest goes
  int max_positions = 4000;        ///< kept for items that come late
};

/// Velocity in the robot frame.
struct Twist {
  double vx = 0.0;  ///< [m/s] forward
  double vy = 0.0;  ///< [m/s] left
  double va = 0.0;  ///< [rad/s]
};

/// Where the robot was, and how it moved, when an item was measured.
struct AlignedPosition {
  Position robot_in_zero;
  Twist twist;                   ///< over the bracket; zero where one position served alone
  std::int64_t zero_utime = 0;   ///< names the zero frame
  bool began_anew = false;       ///< another segment than that of the item before
};

namespace drop_reason {
inline constexpr std::string_view before_first = "before the first position";
inline constexpr std::string_view after_last = "after the last position";
inline constexpr std::string_view gap = "positions around it too far apart";
inline constexpr std::string_view no_session = "no position in its session";
inline constexpr std::string_view overflow = "waited too long for a position";
inline constexpr std::string_view forgotten = "its positions are forgotten";
}  // namespace drop_reason

/// The positions, in segments, and the question what an item's fate is.
class PositionHistory {
 public:
  struct Fate {
    enum class Kind { paired, wait, dropped } kind = Kind::wait;
    AlignedPosition position;     ///< where paired
    std::string_view reason;      ///< where dropped
    bool extrapolated = false;
  };

  explicit PositionHistory(const AlignerParameters& parameters) : parameters_(parameters) {}

  /// `restarted`: the channel's time stepped back within the session.
  void add(const Stamp& stamp, bool restarted, std::int64_t zero_utime,
           const Position& robot_in_zero);

  /// `restarted`: the items' time stepped back within the session since the item before.
  /// Once an item is paired or dropped, later items are not looked for in earlier segments.
  Fate decide(const Stamp& item, bool restarted);

  bool has_session(std::int64_t session) const;

 private:
  struct Sample {
    std::int64_t utime;
    Position robot_in_zero;
  };
  struct PositionSegment {
    std::int64_t number;  ///< counted from 0
    std::int64_t session;
    std::int64_t zero_utime;
    std::deque<Sample> samples;
    bool forgot_some = false;
  };
  // (implementation detail)
  AlignerParameters parameters_;
  std::deque<PositionSegment> segments_;
};

}  // namespace perceptor
