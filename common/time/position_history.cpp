#include "common/time/position_history.hpp"

#include <algorithm>
#include <cmath>

namespace perceptor {

void PositionHistory::add(const Stamp& stamp, bool began_anew, std::int64_t zero_utime,
                          const Position& robot_in_zero) {
  const bool goes_on = !segments_.empty() && !began_anew &&
                       segments_.back().session == stamp.session &&
                       segments_.back().zero_utime == zero_utime;
  if (!goes_on) segments_.push_back({segments_made_++, stamp.session, zero_utime, {}, false});
  segments_.back().samples.push_back({stamp.utime, robot_in_zero});
  ++samples_;
  if (samples_ > static_cast<std::size_t>(std::max(parameters_.max_positions, 2))) forget_oldest();
}

void PositionHistory::forget_oldest() {
  TrackSegment& oldest = segments_.front();
  oldest.samples.pop_front();
  oldest.forgot_some = true;
  --samples_;
  if (oldest.samples.empty()) segments_.pop_front();
}

bool PositionHistory::knows_session(std::int64_t session) const {
  return std::ranges::any_of(segments_, [&](const auto& s) { return s.session == session; });
}

PositionHistory::Fate PositionHistory::decide(const Stamp& item, bool began_anew) {
  if (began_anew && last_paired_in_)
    first_allowed_ = std::max(first_allowed_, *last_paired_in_ + 1);

  bool passed_one = false;
  for (const TrackSegment& segment : segments_) {
    if (segment.number < first_allowed_ || segment.session != item.session) continue;
    const bool over = segment.number != segments_.back().number;
    if (over && item.utime > segment.samples.back().utime + kSameTime) {
      passed_one = true;
      continue;
    }
    Fate fate = decide_in(segment, item.utime);
    if (auto* paired = std::get_if<AlignedPosition>(&fate)) {
      paired->began_anew = last_paired_in_ != segment.number;
      last_paired_in_ = segment.number;
    }
    return fate;
  }
  if (passed_one) return DropReason{drop_reason::after_last};
  return Wait{};
}

PositionHistory::Fate PositionHistory::decide_in(const TrackSegment& segment, std::int64_t utime) {
  const auto& samples = segment.samples;
  const auto candidate = std::ranges::lower_bound(samples, utime - kSameTime, {}, &Sample::utime);
  const auto index = static_cast<std::size_t>(candidate - samples.begin());

  depends_on_arrival_ |= index == 0 && segment.forgot_some;
  if (candidate != samples.end() && candidate->utime <= utime + kSameTime)
    return aligned(segment, candidate->robot_in_zero, twist_up_to(segment, index));

  if (index == 0)
    return DropReason{segment.forgot_some ? drop_reason::forgotten : drop_reason::before_first};

  const Sample& before = samples[index - 1];
  const double since = seconds_between(before.utime, utime);
  if (candidate == samples.end()) {
    if (since > parameters_.max_extrapolation) return Wait{};
    depends_on_arrival_ = true;
    const Twist twist = twist_up_to(segment, index - 1);
    return aligned(segment, compose(before.robot_in_zero, move(twist, since)), twist);
  }

  const double width = seconds_between(before.utime, candidate->utime);
  if (width > parameters_.max_gap) return DropReason{drop_reason::gap};
  const Twist twist = twist_between(before.robot_in_zero, candidate->robot_in_zero, width);
  return aligned(segment, compose(before.robot_in_zero, move(twist, since)), twist);
}

Twist PositionHistory::twist_up_to(const TrackSegment& segment, std::size_t sample) const {
  if (sample == 0) return {};
  const Sample& from = segment.samples[sample - 1];
  const Sample& to = segment.samples[sample];
  const double width = seconds_between(from.utime, to.utime);
  if (width > parameters_.max_gap) return {};
  return twist_between(from.robot_in_zero, to.robot_in_zero, width);
}

AlignedPosition PositionHistory::aligned(const TrackSegment& segment, const Position& robot_in_zero,
                                         const Twist& twist) {
  return {robot_in_zero, twist, segment.zero_utime, false};
}

}  // namespace perceptor
