#include "tools/top/channel_table.hpp"

#include "common/bus/channels.hpp"
#include "common/messages/schema.hpp"
#include "common/text/format.hpp"
#include "common/time/stamp.hpp"

namespace perceptor {
namespace {

constexpr std::int64_t kWindow = 2 * kMicrosecondsPerSecond;
constexpr double kSilent = 3.0;  // [s] slower than what our components send by themselves

/// Commands come when there is something to say, and what others send is theirs to know.
bool comes_by_itself(const std::string& name) {
  return channel::type_on(name) != nullptr && !name.starts_with(channel::command_prefix);
}

}  // namespace

void ChannelTable::take(const std::string& name, Bytes payload, std::int64_t now) {
  Channel& channel = channels_[name];
  channel.recent.push_back({now, payload.size()});
  while (channel.recent.size() > 1 && channel.recent.front().when < now - kWindow)
    channel.recent.pop_front();

  const lcm_type_info_t* type = channel::type_on(name);
  if (type == nullptr) return;
  if (!messages::find_fault(type, payload).empty()) {
    ++channel.bad;
    return;
  }
  const bool has_stamp = !name.starts_with(channel::status_prefix);
  if (has_stamp) channel.watch.check(messages::stamp_in(payload).value_or(Stamp{}));
}

std::vector<Row> ChannelTable::rows(std::int64_t now) const {
  std::vector<Row> rows = {{format("%-22s %8s %9s %8s %8s %6s %9s", "CHANNEL", "Hz", "kB/s",
                                   "bytes", "missed", "bad", "age [s]"),
                            Row::Look::title}};
  for (const auto& [name, channel] : channels_) {
    double count = 0.0;
    double bytes = 0.0;
    for (const Arrival& arrival : channel.recent) {
      if (arrival.when < now - kWindow) continue;
      count += 1.0;
      bytes += static_cast<double>(arrival.size);
    }
    const double seconds = seconds_between(0, kWindow);
    const double age = seconds_between(channel.recent.back().when, now);
    const bool is_alarming =
        channel.bad > 0 || channel.watch.missed() > 0 || (age > kSilent && comes_by_itself(name));
    rows.push_back({format("%-22s %8.1f %9.1f %8zu %8lld %6lld %9.1f", name.c_str(),
                           count / seconds, bytes / seconds / 1000.0, channel.recent.back().size,
                           static_cast<long long>(channel.watch.missed()),
                           static_cast<long long>(channel.bad), age),
                    is_alarming ? Row::Look::alarm : Row::Look::plain});
  }
  return rows;
}

}  // namespace perceptor
