#include "tools/plot/log_scene.hpp"

#include <algorithm>
#include <optional>

#include <lcm/lcm-cpp.hpp>

#include "common/bus/bus.hpp"
#include "common/bus/channels.hpp"
#include "common/log/event_log.hpp"
#include "common/messages/schema.hpp"
#include "common/time/stamp.hpp"
#include "components/viewer/listen.hpp"
#include "tools/progress.hpp"

namespace perceptor {
namespace {

/// [us] When the measurement was taken that a message is of; none where it says something else.
std::optional<std::int64_t> measured_at(const LogEvent& event) {
  const bool says_something_else = event.channel == channel::global_map ||
                                   event.channel.starts_with(channel::status_prefix) ||
                                   event.channel.starts_with(channel::command_prefix);
  const lcm_type_info_t* type = channel::type_on(event.channel);
  if (says_something_else || !messages::find_fault(type, event.data).empty()) return std::nullopt;
  return messages::stamp_in(event.data)->utime;
}

}  // namespace

LogScene scene_of_log(const std::filesystem::path& log, double at) {
  lcm::LCM lcm("memq://");
  Status status("plot", 0);
  viewer::Newest newest;
  Bus bus(lcm, lcm, status);
  viewer::listen(bus, newest);

  LogReader reader(log);
  Progress progress("reading", reader.size());
  LogScene found;
  std::optional<std::int64_t> first;
  for (LogEvent event; reader.next(event);) {
    if (channel::type_on(event.channel) == nullptr) continue;
    if (const auto measured = measured_at(event)) {
      if (!first) first = measured;
      const double seconds = seconds_between(*first, *measured);
      if (seconds > at) break;
      found.seconds = std::max(found.seconds, seconds);
    }
    progress.at(reader.offset());
    lcm.publish(event.channel, event.data.data(), static_cast<unsigned>(event.data.size()));
    while (lcm.handleTimeout(0) > 0) {
    }
  }
  if (!first) throw LogError(log.string() + ": holds no measurement");
  found.scene = newest.scene();
  for (const auto& input : status.message(0, true).inputs) found.rejected += input.rejected;
  return found;
}

}  // namespace perceptor
