#include "common/time/continuity.hpp"

namespace perceptor {

Continuity ContinuityWatch::check(const Stamp& stamp) {
  if (!last_) {
    last_ = stamp;
    return Continuity::began_anew;
  }
  const bool new_session = stamp.session != last_->session;
  const std::int64_t step = stamp.utime - last_->utime;
  if (new_session || step < -kRestartStep) {
    last_ = stamp;
    ++restarts_;
    return Continuity::began_anew;
  }
  if (step < 0) return Continuity::stepped_back;
  if (step == 0) return Continuity::repeated;
  if (stamp.seq > last_->seq + 1) missed_ += stamp.seq - last_->seq - 1;
  last_ = stamp;
  return Continuity::continues;
}

}  // namespace perceptor
