/// @file The robot's positions over time, and what they decide about an item measured at T.
///
/// Positions come in segments: runs of one session and one zero frame in which time only goes
/// forward. Nothing is interpolated across the border of a segment.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string_view>
#include <variant>

#include "common/geometry/twist.hpp"
#include "common/time/stamp.hpp"

namespace perceptor {

struct AlignerParameters {
  double max_gap = 0.5;            ///< [s] wider brackets are not trusted: the item is dropped
  double max_extrapolation = 0.0;  ///< [s] pair without waiting, up to this far ahead; results
                                   ///< then depend on arrival, and STATUS says degraded
  int max_items = 100;             ///< may wait for their bracket; beyond it the oldest goes
  int max_positions = 4000;        ///< kept for items that come late
};

/// Where the robot was, and how it moved, when an item was measured.
struct AlignedPosition {
  Position robot_in_zero;
  Twist twist;                  ///< over the bracket, or up to the position that served alone
  std::int64_t zero_utime = 0;  ///< names the zero frame
  bool began_anew = false;      ///< another segment than that of the item before
};

struct DropReason {
  std::string_view text;
};

namespace drop_reason {
inline constexpr std::string_view before_first = "before the first position";
inline constexpr std::string_view after_last = "after the last position";
inline constexpr std::string_view gap = "positions around it too far apart";
inline constexpr std::string_view no_session = "no position in its session";
inline constexpr std::string_view overflow = "waited too long for a position";
inline constexpr std::string_view forgotten = "its positions are forgotten";
}  // namespace drop_reason

class PositionHistory {
 public:
  struct Wait {};
  using Fate = std::variant<Wait, AlignedPosition, DropReason>;

  /// A position this close to the item serves alone [us].
  static constexpr std::int64_t kSameTime = 1000;

  explicit PositionHistory(const AlignerParameters& parameters) : parameters_(parameters) {}

  /// `began_anew`: the channel's time stepped back, or its session is new.
  void add(const Stamp& stamp, bool began_anew, std::int64_t zero_utime,
           const Position& robot_in_zero);

  /// What becomes of the item. Items are asked for in their order; one that waits is asked for
  /// again. `began_anew`: since the item before, the items' time stepped back, or their session
  /// is new: the segment of the items before is then over for this one.
  Fate decide(const Stamp& item, bool began_anew);

  bool knows_session(std::int64_t session) const;

  /// Forgets which segments are over for the items: the way out when they waited in vain.
  void allow_all_segments() { first_allowed_ = 0; }

  bool depends_on_arrival() const { return depends_on_arrival_; }

 private:
  struct Sample {
    std::int64_t utime;
    Position robot_in_zero;
  };
  struct TrackSegment {
    std::int64_t number;  ///< counted from 0
    std::int64_t session;
    std::int64_t zero_utime;
    std::deque<Sample> samples;  ///< never empty
    bool forgot_some = false;
  };

  Fate decide_in(const TrackSegment& segment, std::int64_t utime);
  Twist twist_up_to(const TrackSegment& segment, std::size_t sample) const;
  static AlignedPosition aligned(const TrackSegment& segment, const Position& robot_in_zero,
                                 const Twist& twist);
  void forget_oldest();

  AlignerParameters parameters_;
  std::deque<TrackSegment> segments_;
  std::size_t samples_ = 0;
  std::int64_t segments_made_ = 0;
  std::int64_t first_allowed_ = 0;              ///< items do not look in earlier segments
  std::optional<std::int64_t> last_paired_in_;  ///< number of a segment
  bool depends_on_arrival_ = false;
};

}  // namespace perceptor
