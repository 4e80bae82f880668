#include "common/time/continuity.hpp"

#include <algorithm>
#include <limits>

namespace perceptor {

std::int64_t SequenceWindow::take(std::int64_t seq) {
  constexpr int kWidth = std::numeric_limits<std::uint64_t>::digits;
  if (seq > highest_) {
    const std::int64_t step = seq - highest_;
    came_ = (step < kWidth ? came_ << step : 0) | 1U;
    highest_ = seq;
    return step - 1;
  }
  const std::int64_t back = highest_ - seq;
  if (back >= kWidth || (came_ >> back & 1U) != 0) return 0;
  came_ |= std::uint64_t{1} << back;
  return -1;
}

Continuity ContinuityWatch::check(const Stamp& stamp) {
  if (!last_) {
    begin(stamp);
    return Continuity::began_anew;
  }
  const bool new_session = stamp.session != last_->session;
  const std::int64_t step = stamp.utime - last_->utime;
  if (new_session || step < -kRestartStep) {
    begin(stamp);
    ++restarts_;
    return Continuity::began_anew;
  }
  if (++in_session_ >= kTurn) is_contested_ = false;
  missed_ = std::min(missed_ + window_.take(stamp.seq), kMostMissed);
  if (step < 0) return Continuity::stepped_back;
  if (step == 0) return Continuity::repeated;
  last_ = stamp;
  return Continuity::continues;
}

void ContinuityWatch::begin(const Stamp& stamp) {
  if (last_ && stamp.session != last_->session) {
    is_contested_ = stamp.session == session_before_ && in_session_ < kTurn;
    session_before_ = last_->session;
    in_session_ = 0;
  }
  window_ = SequenceWindow(stamp.seq);
  last_ = stamp;
}

std::string_view order_fault(Continuity continuity) {
  switch (continuity) {
    case Continuity::stepped_back:
      return "time stepped back";
    case Continuity::repeated:
      return "time stood still";
    case Continuity::continues:
    case Continuity::began_anew:
      break;
  }
  return {};
}

}  // namespace perceptor
