/// @file pico-replay: runs a log through all perceiving components in one process, as fast as
/// it goes. Reads PICO_*, passes SIM_* on, and writes them with what the components say.
#include <chrono>
#include <iostream>

#include "common/bus/channels.hpp"
#include "common/log/event_log.hpp"
#include "common/runner/memory.hpp"
#include "tools/cli.hpp"
#include "tools/progress.hpp"
#include "tools/replay/pipeline.hpp"

namespace perceptor {
namespace {

struct Counts {
  std::int64_t events = 0;
  std::int64_t fed = 0;
  std::int64_t first_utime = 0;
  std::int64_t last_utime = 0;
};

bool is_input(const std::string& channel) { return channel.starts_with("PICO_"); }
bool is_truth(const std::string& channel) { return channel.starts_with("SIM_"); }

Counts replay(LogReader& reader, LogWriter& writer, const PipelineConfig& config) {
  std::int64_t stamp = 0;
  Pipeline pipeline(config, 0, [&](const std::string& channel, Pipeline::Bytes payload) {
    writer.write(channel, stamp, payload.data(), payload.size());
  });

  Counts counts;
  std::int64_t next_status = 0;
  Progress progress("replaying", reader.size());
  LogEvent event;
  while (reader.next(event)) {
    ++counts.events;
    progress.at(reader.offset());
    if (is_truth(event.channel))
      writer.write(event.channel, event.timestamp, event.data.data(), event.data.size());
    if (!is_input(event.channel)) continue;

    stamp = event.timestamp;
    const std::int64_t utime = messages::stamp_in(event.data).value_or(Stamp{}).utime;
    if (counts.fed++ == 0) {
      counts.first_utime = utime;
      pipeline.publish_status(utime);
      next_status = utime + kMicrosecondsPerSecond;
    }
    pipeline.feed(event.channel, event.data);
    counts.last_utime = utime;
    if (utime >= next_status) {
      pipeline.publish_status(utime);
      next_status = utime + kMicrosecondsPerSecond;
    }
  }
  pipeline.finish(counts.last_utime);
  writer.close();
  return counts;
}

struct ReplayOptions {
  std::filesystem::path in;
  std::filesystem::path out;
  std::filesystem::path config_dir = default_config_directory();
  std::vector<std::string> overrides;
  std::string map;
};

int replay_log(const ReplayOptions& options) {
  keep_freed_memory();
  const PipelineConfig config =
      load_pipeline_config(options.config_dir, options.overrides, options.map);
  std::error_code not_there;
  if (std::filesystem::equivalent(options.in, options.out, not_there))
    throw config::Error("IN and OUT are the same file");
  LogReader reader(options.in);
  LogWriter writer(options.out);
  const auto started = std::chrono::steady_clock::now();
  const Counts counts = replay(reader, writer, config);
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - started;
  const double covered = seconds_between(counts.first_utime, counts.last_utime);
  std::cerr << "pico-replay: " << counts.fed << " of " << counts.events << " events fed, "
            << covered << " s of robot time in " << spent.count() << " s\n";
  for (const LogDamage& damage : reader.damage())
    std::cerr << "pico-replay: " << options.in.string() << ": " << damage.size
              << " damaged bytes passed over at byte " << damage.offset << '\n';
  if (counts.fed == 0)
    std::cerr << "pico-replay: " << options.in.string() << " holds no PICO_* message\n";
  return counts.fed > 0 && reader.damage().empty() ? kExitOk : kExitFailed;
}

}  // namespace
}  // namespace perceptor

int main(int argc, char** argv) {
  perceptor::ReplayOptions options;
  CLI::App app{
      "Runs a log through locate, proximity, scan, merge and identify in one process, as fast as\n"
      "it goes; with --map through localize too. The same log gives the same bytes, whenever and\n"
      "wherever.",
      "pico-replay"};
  app.add_option("IN", options.in, "an LCM event log; its PICO_* channels are the input")
      ->required();
  app.add_option("OUT", options.out,
                 "the log to write: input, truth where there is one, and output")
      ->required();
  app.add_option("--config-dir", options.config_dir, "folder of the components' JSON files")
      ->capture_default_str();
  app.add_option("--set", options.overrides, "component.key=value, as in scan.aligner.max_gap=3")
      ->allow_extra_args(false);
  app.add_option("--map", options.map,
                 "the building, for localize: a name in the folder maps, or a JSON file");
  app.footer(
      "Examples:\n"
      "  pico-replay drive.lcmlog replayed.lcmlog --set scan.aligner.max_gap=3\n"
      "  pico-replay drive.lcmlog replayed.lcmlog --map hospital");
  return perceptor::run_tool(app, argc, argv, [&] { return perceptor::replay_log(options); });
}
