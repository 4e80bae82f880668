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
#include "tests/support/sanitized.hpp"

namespace perceptor::test {
namespace {

namespace fs = std::filesystem;

constexpr double kPace = kSanitized ? 0.2 : 1.0;  // a sanitizer's programs are slower

struct RecordedRun {
  const char* name;
  double speed;                        ///< for some 150 scans a second
  std::vector<std::string> convert{};  ///< options of pico-convert
  const char* max_gap = nullptr;       ///< [s] for the aligner; none: its default
};

void PrintTo(const RecordedRun& run, std::ostream* out) { *out << run.name; }

/// What was on the bus.
struct Heard {
  std::map<std::string, pico::status_t> last_status;      ///< by component
  std::map<std::string, std::vector<std::int64_t>> seqs;  ///< of maps, by channel
  std::map<std::string, std::int64_t> messages;           ///< by channel
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
    ++heard.messages[event->channel];
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

/// Whether every process received each message that the logger did.
bool all_arrived(const Heard& heard) {
  for (const auto& [component, status] : heard.last_status)
    for (const pico::status_input_t& input : status.inputs)
      if (const auto sent = heard.messages.find(input.channel);
          sent != heard.messages.end() && sent->second != input.received)
        return false;
  return true;
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
  // A busy machine loses datagrams, and nobody could help it: then once more, slower.
  const fs::path live = scratch / "live.lcmlog";
  Heard heard;
  Finished check;
  for (const double speed : {kPace * run_of.speed, 0.2 * kPace * run_of.speed}) {
    fs::remove(live);
    Recording recording(live, options);
    const Finished bridge = run({program("pico-bridge"), "--source", "log:" + converted.string(),
                                 "--speed", std::to_string(speed)},
                                Seconds(300));
    EXPECT_EQ(bridge.exit_code, 0) << bridge.output;
    EXPECT_TRUE(recording.stop());
    heard = hear(live);
    check = run({program("pico-logcheck"), live});
    if (check.exit_code == 0 && all_arrived(heard)) break;
  }
  EXPECT_EQ(check.exit_code, 0) << check.output;
  EXPECT_TRUE(all_arrived(heard));

  const pico::status_t& scan = heard.last_status["scan"];
  const std::vector<std::int64_t>& current_maps = heard.seqs[channel::current_map];
  const auto maps = static_cast<std::int64_t>(current_maps.size());
  EXPECT_TRUE(scan.last);
  EXPECT_FALSE(scan.degraded) << scan.note;
  EXPECT_EQ(received(scan, channel::laser), scans);
  EXPECT_EQ(published(scan, channel::current_map), maps);
  EXPECT_EQ(maps + dropped_scans(scan), scans);

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
  EXPECT_EQ(heard.messages[channel::entrance], maps);

  const Finished replayed = run(replay);
  ASSERT_EQ(replayed.exit_code, 0) << replayed.output;
  EXPECT_TRUE(computed_payloads(scratch / "replayed.lcmlog") == computed_payloads(live))
      << "pico-replay says other bytes than the processes";
}

INSTANTIATE_TEST_SUITE_P(
    All, RecordedRuns,
    ::testing::Values(RecordedRun{"pico_static", 4.0, {"--still"}},
                      RecordedRun{"uob_p3dx_trace0", 15.0}, RecordedRun{"csail", 60.0},
                      // Its odometry comes once a second, and late at times.
                      RecordedRun{"intel_raw", 150.0, {}, "3"},
                      // Some 300 beams in a turn of 0.15 s, while the robot turns at 3 rad/s.
                      RecordedRun{"lcm_mbot_convex", 7.0, {"--time-increment", "0.0005"}},
                      RecordedRun{"mines_exp1", 15.0}),
    [](const auto& each) { return std::string(each.param.name); });

}  // namespace
}  // namespace perceptor::test
