#include "components/viewer/channel_clock.hpp"

#include <algorithm>
#include <array>

#include "common/bus/channels.hpp"
#include "common/text/format.hpp"
#include "common/time/continuity.hpp"

namespace perceptor::viewer {
namespace {

/// The others may be silent for a while.
constexpr std::array kSteadyChannels = {
    channel::laser,     channel::position,       channel::proximity,     channel::current_map,
    channel::local_map, channel::identified_map, channel::world_position};

}  // namespace

bool ChannelClock::take(const std::string& channel, std::int64_t utime, std::int64_t session) {
  const bool is_another_session = session_ && *session_ != session;
  const auto last = heard(channel);
  const bool steps_back = last && utime < *last - ContinuityWatch::kRestartStep;
  const bool goes_on = !is_another_session && !steps_back;
  if (!goes_on) heard_.clear();
  session_ = session;
  heard_[channel] = utime;
  return goes_on;
}

std::optional<std::int64_t> ChannelClock::heard(const std::string& channel) const {
  const auto found = heard_.find(channel);
  if (found == heard_.end()) return std::nullopt;
  return found->second;
}

std::int64_t ChannelClock::now() const {
  std::int64_t newest = 0;
  for (const auto& [channel, utime] : heard_) newest = std::max(newest, utime);
  return newest;
}

std::vector<std::string> ChannelClock::notes(double stale) const {
  std::vector<std::string> notes;
  for (const char* channel : kSteadyChannels) {
    const auto last = heard(channel);
    if (!last) continue;
    const double age = seconds_between(*last, now());
    if (age > stale) notes.push_back(format("%s is %.0f s old", channel, age));
  }
  return notes;
}

}  // namespace perceptor::viewer
