#include "tools/plot/log_scene.hpp"

#include <optional>

#include <lcm/lcm-cpp.hpp>

#include "common/bus/bus.hpp"
#include "common/bus/channels.hpp"
#include "common/log/event_log.hpp"
#include "common/time/stamp.hpp"
#include "components/viewer/listen.hpp"
#include "tools/progress.hpp"

namespace perceptor {

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
    if (!first) first = event.timestamp;
    const double seconds = seconds_between(*first, event.timestamp);
    if (seconds > at) break;
    found.seconds = seconds;
    progress.at(reader.offset());
    if (channel::type_on(event.channel) == nullptr) continue;
    lcm.publish(event.channel, event.data.data(), static_cast<unsigned>(event.data.size()));
    while (lcm.handleTimeout(0) > 0) {
    }
  }
  if (!first) throw LogError(log.string() + ": holds no event");
  found.scene = newest.scene();
  for (const auto& input : status.message(0, true).inputs) found.rejected += input.rejected;
  return found;
}

}  // namespace perceptor
