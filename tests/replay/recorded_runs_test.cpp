/// Recorded robots through the real processes: nothing is lost, and nothing goes uncounted.
#include <fstream>
#include <numeric>
#include <set>

#include <gtest/gtest.h>
#include <pico/map_t.hpp>

#include "common/bus/bus.hpp"
#include "common/bus/channels.hpp"
#include "common/time/position_history.hpp"
#include "tests/process/harness.hpp"
#include "tests/replay/recording_text.hpp"
#include "tests/support/recorded_data.hpp"

namespace perceptor::test {
namespace {

namespace fs = std::filesystem;

struct RecordedRun {
  const char* name;
  const char* speed;                   ///< for some 400 messages a second: none is lost on the way
  std::vector<std::string> convert{};  ///< options of pico-convert
  const char* max_gap = nullptr;       ///< [s] for the aligner; none: its default
};

void PrintTo(const RecordedRun& run, std::ostream* out) { *out << run.name; }

/// What was on the bus.
struct Heard {
  std::map<std::string, pico::status_t> last_status;      ///< by component
  std::map<std::string, std::vector<std::int64_t>> seqs;  ///< of maps, by channel
};

template <class Message>
Message decoded(const LogEvent& event) {
  Message message;
  EXPECT_EQ(detail::decode(event.data, message), "") << event.channel;
  return message;
}

Heard hear(const fs::path& log) {
  Heard heard;
  LogReader reader(log);
  while (const auto event = reader.next()) {
    if (event->channel.starts_with("STATUS_")) {
      const auto status = decoded<pico::status_t>(*event);
      heard.last_status[status.component] = status;
    }
    for (const char* map : {channel::current_map, channel::local_map, channel::identified_map})
      if (event->channel == map) heard.seqs[map].push_back(decoded<pico::map_t>(*event).seq);
  }
  EXPECT_TRUE(reader.damage().empty());
  return heard;
}

/// Scans that scan said it dropped, whatever the reason.
std::int64_t dropped_scans(const pico::status_t& scan) {
  std::int64_t dropped = 0;
  for (const std::string_view reason :
       {drop_reason::before_first, drop_reason::after_last, drop_reason::gap,
        drop_reason::no_session, drop_reason::overflow, drop_reason::forgotten})
    dropped += rejected(scan, channel::laser, std::string(reason));
  return dropped;
}

/// Scans that are measured after the last odometry: the recording ends before their fate is
/// known. An odometry within a millisecond decides.
std::int64_t undecided_scans(const TextRecording& text) {
  const bool still = text.last_odometry == 0.0;
  if (still) return 0;
  return std::ranges::count_if(
      text.scans, [&](const TextScan& scan) { return scan.time > text.last_odometry + 0.001; });
}

class RecordedRuns : public ::testing::TestWithParam<RecordedRun> {};

TEST_P(RecordedRuns, EveryScanAndBeamIsAccountedFor) {
  const RecordedRun& run_of = GetParam();
  const std::string file = "logs/" + std::string(run_of.name) + ".log.xz";
  PERCEPTOR_REQUIRE_RECORDED(file);
  const std::string text = testing::unpacked(*testing::recorded(file));
  const TextRecording expected = read_text(text);
  const auto scans = static_cast<std::int64_t>(expected.scans.size());
  ASSERT_GT(scans, 0);

  const ScratchFolder scratch;
  const fs::path converted = scratch / "converted.lcmlog";
  std::ofstream(scratch / "recording.log") << text;
  std::vector<std::string> convert{program("pico-convert"), scratch / "recording.log", converted};
  convert.insert(convert.end(), run_of.convert.begin(), run_of.convert.end());
  const Finished conversion = run(convert);
  ASSERT_EQ(conversion.exit_code, 0) << conversion.output;

  Recording::Options options;
  std::vector<std::string> replay{program("pico-replay"), converted, scratch / "replayed.lcmlog"};
  if (run_of.max_gap != nullptr) {
    options["scan"] = {"--set", std::string("aligner.max_gap=") + run_of.max_gap};
    replay.insert(replay.end(), {"--set", std::string("scan.aligner.max_gap=") + run_of.max_gap});
  }
  const fs::path live = scratch / "live.lcmlog";
  Recording recording(live, options);
  const Finished bridge = run(
      {program("pico-bridge"), "--source", "log:" + converted.string(), "--speed", run_of.speed});
  EXPECT_EQ(bridge.exit_code, 0) << bridge.output;
  EXPECT_TRUE(recording.stop());

  Heard heard = hear(live);
  const pico::status_t& scan = heard.last_status["scan"];
  const std::vector<std::int64_t>& current_maps = heard.seqs[channel::current_map];
  const auto maps = static_cast<std::int64_t>(current_maps.size());
  EXPECT_TRUE(scan.last);
  EXPECT_FALSE(scan.degraded) << scan.note;
  EXPECT_EQ(received(scan, channel::laser), scans);
  EXPECT_EQ(published(scan, channel::current_map), maps);
  EXPECT_EQ(maps + dropped_scans(scan) + undecided_scans(expected), scans);

  const auto without_return = [&](std::int64_t sum, std::int64_t seq) {
    return sum + expected.scans.at(static_cast<std::size_t>(seq)).beams_without_return;
  };
  EXPECT_EQ(
      rejected(scan, channel::laser, "beam without return"),
      std::accumulate(current_maps.begin(), current_maps.end(), std::int64_t{0}, without_return));
  EXPECT_EQ(received(heard.last_status["proximity"], channel::laser), scans);

  EXPECT_EQ(std::set<std::int64_t>(current_maps.begin(), current_maps.end()).size(),
            current_maps.size());
  EXPECT_EQ(heard.seqs[channel::local_map], current_maps);
  EXPECT_EQ(heard.seqs[channel::identified_map], current_maps);

  const Finished check = run({program("pico-logcheck"), live});
  EXPECT_EQ(check.exit_code, 0) << check.output;

  const Finished replayed = run(replay);
  ASSERT_EQ(replayed.exit_code, 0) << replayed.output;
  EXPECT_TRUE(computed_payloads(scratch / "replayed.lcmlog") == computed_payloads(live))
      << "pico-replay says other bytes than the processes";
}

INSTANTIATE_TEST_SUITE_P(
    All, RecordedRuns,
    ::testing::Values(RecordedRun{"pico_static", "4", {"--still"}},
                      RecordedRun{"uob_p3dx_trace0", "20"}, RecordedRun{"csail", "56"},
                      // Its odometry comes once a second, and late at times.
                      RecordedRun{"intel_raw", "200", {}, "3"},
                      // Some 300 beams in a turn of 0.15 s, while the robot turns at 3 rad/s.
                      RecordedRun{"lcm_mbot_convex", "7", {"--time-increment", "0.0005"}},
                      RecordedRun{"mines_exp1", "20"}),
    [](const auto& each) { return std::string(each.param.name); });

}  // namespace
}  // namespace perceptor::test
