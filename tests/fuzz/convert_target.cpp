/// A text log, converted into an LCM log.
#include <sstream>

#include "common/log/event_log.hpp"
#include "tests/fuzz/target.hpp"
#include "tools/convert/conversion.hpp"
#include "tools/convert/recording_reader.hpp"

namespace perceptor::fuzz {

std::vector<Bytes> seeds() {
  return {bytes_of("# laser_pose 0.1 0 0\n# valid_max 10\n"
                   "ODOM 1.0 0.0 0.0 0.0\nLASER 1.1 -1.5 1.5 81.9 3 1.0 nan 3.0\n"
                   "LASERA 1.2 30 2 -0.5 1.0 0.5 inf\nODOM 1.3 0.1 0.0 0.01\n"),
          bytes_of("PARAM robot_front_laser_max 81.9\n"
                   "ODOM 0.5 0.5 0.1 0.2 0.0 0.0 1.4 host 1.4\n"
                   "FLASER 3 1.0 2.0 3.0 0.5 0.5 0.1 0.5 0.5 0.1 1.5 host 1.5\n"
                   "ODOM 0.6 0.5 0.1 0.2 0.0 0.0 1.6 host 1.6\n")};
}

}  // namespace perceptor::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace perceptor;
  std::istringstream in(std::string(reinterpret_cast<const char*>(data), size));
  const fuzz::MemoryFile out;
  try {
    const ConversionSummary summary = convert(in, "fuzz", out.path(), ConversionOptions{});
    LogReader log(out.path());
    std::int64_t events = 0;
    for (LogEvent event; log.next(event);)
      if (event.channel.starts_with("PICO_")) ++events;  // its STATUS is in the log as well
    fuzz::require(log.damage().empty(), "what is written can be read");
    fuzz::require(events == summary.scans + summary.odometry,
                  "as many measurements as were counted");
  } catch (const NotARecording&) {
    return 0;  // with a reason
  }
  return 0;
}
