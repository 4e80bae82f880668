#include "tools/eval/log_scans.hpp"

#include <string_view>

#include <pico/laser_scan_t.hpp>

#include "common/bus/bus.hpp"
#include "common/bus/channels.hpp"
#include "common/messages/convert.hpp"

namespace perceptor {
namespace {

LabelledScan labelled(std::int64_t id, const pico::laser_scan_t& message) {
  LabelledScan scan;
  scan.id = id;
  scan.time = seconds_between(0, message.utime);
  scan.scan = to_model(message);
  return scan;
}

}  // namespace

LogScans read_log_scans(const std::filesystem::path& log,
                        const std::function<void(std::int64_t)>& progress) {
  LogReader reader(log);
  LogScans scans;
  std::int64_t id = 0;
  LogEvent event;
  while (reader.next(event)) {
    progress(reader.offset());
    if (event.channel != channel::laser) continue;
    pico::laser_scan_t message;
    if (const std::string_view fault = detail::decode(event.data, message); fault.empty())
      scans.set.scans.push_back(labelled(id, message));
    else if (scans.undecodable++ == 0)
      scans.first_fault = fault;
    ++id;
  }
  scans.damage = reader.damage();
  if (scans.set.scans.empty())
    throw LogError(log.string() + " holds no " + channel::laser + " message" +
                   (scans.undecodable > 0 ? " that can be decoded: " + scans.first_fault : ""));
  return scans;
}

}  // namespace perceptor
