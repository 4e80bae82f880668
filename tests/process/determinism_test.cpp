/// The same measurements give the same bytes: live, played again at any speed, replayed in one
/// process, and replayed with the channels shifted against each other.
#include <deque>
#include <iostream>
#include <random>

#include <gtest/gtest.h>

#include "tests/process/harness.hpp"
#include "tests/support/sanitized.hpp"

namespace perceptor::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* kDriven = "12";  // seconds of robot time

// Under a sanitizer the processes keep up with real time, and with no more than that.
const std::vector<std::string> kPlayed = {kSanitized ? "0.5" : "1", kSanitized ? "1" : "4"};
constexpr const char* kBridged = kSanitized ? "1" : "3";

/// What the processes say when `source` feeds them. UDP and lcm-logger may lose messages while
/// the machine is busy: a log that is shown to lack some proves nothing, and is made again.
Payloads computed_live(const fs::path& log, const std::vector<std::string>& source) {
  constexpr int kAttempts = 3;
  Finished check;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    Recording recording(log, {{"localize", {"--map", "hospital"}}});
    Process process(source);
    EXPECT_EQ(process.wait(Seconds(60)), 0) << source.front();
    EXPECT_TRUE(recording.stop());
    check = run({program("pico-logcheck"), log});
    constexpr int kMissing = 1;
    if (check.exit_code != kMissing) return computed_payloads(log);
    std::cerr << "recorded again: messages were lost on the way\n";
  }
  ADD_FAILURE() << "no complete recording in " << kAttempts << " attempts\n" << check.output;
  return {};
}

Payloads replayed(const fs::path& in, const fs::path& out) {
  const Finished replay = run({program("pico-replay"), in, out, "--map", "hospital"});
  EXPECT_EQ(replay.exit_code, 0) << replay.output;
  return computed_payloads(out);
}

/// Moves messages by up to half a second against those of other channels; within a channel the
/// order stays.
void shift_channels(const fs::path& in, const fs::path& out) {
  constexpr std::int64_t kMostShift = 500'000;  // [us]
  std::map<std::string, std::deque<LogEvent>> channels;
  LogReader reader(in);
  while (auto event = reader.next())
    if (event->channel.starts_with("PICO_")) channels[event->channel].push_back(std::move(*event));

  std::mt19937_64 random(11);
  LogWriter writer(out);
  std::int64_t stamp = 0;
  while (!channels.empty()) {
    std::int64_t oldest = std::numeric_limits<std::int64_t>::max();
    for (const auto& [name, events] : channels) oldest = std::min(oldest, events.front().timestamp);
    // Stay with one channel for a while, as far ahead of the others as is allowed.
    auto& [name, events] =
        *std::next(channels.begin(), static_cast<std::ptrdiff_t>(random() % channels.size()));
    for (auto run = random() % 30; run > 0 && !events.empty(); --run) {
      const LogEvent& event = events.front();
      if (event.timestamp > oldest + kMostShift) break;
      stamp = std::max(stamp, event.timestamp);
      writer.write(event.channel, stamp, event.data.data(), event.data.size());
      events.pop_front();
    }
    if (events.empty()) channels.erase(std::string(name));
  }
  writer.close();
}

void expect_equal(const Payloads& expected, const Payloads& actual, const std::string& what) {
  for (const auto& [channel, payloads] : expected) {
    const auto found = actual.find(channel);
    ASSERT_NE(found, actual.end()) << what << ": nothing on " << channel;
    ASSERT_EQ(found->second.size(), payloads.size()) << what << ": " << channel;
    for (std::size_t i = 0; i < payloads.size(); ++i)
      ASSERT_EQ(found->second[i], payloads[i]) << what << ": " << channel << " number " << i;
  }
}

TEST(Determinism, LivePlayedAgainAndReplayedAreEqualByteForByte) {
  const ScratchFolder scratch;
  const fs::path log = scratch / "live.lcmlog";
  const Payloads live =
      computed_live(log, {program("pico-bridge"), "--world", "hospital", "--duration", kDriven});
  ASSERT_EQ(live.size(), 8U) << "channels";
  EXPECT_GT(live.at("POSITION").size(), 500U);
  EXPECT_GT(live.at("IDENTIFIED_MAP").size(), 400U);
  EXPECT_EQ(live.at("ENTRANCE").size(), live.at("IDENTIFIED_MAP").size());
  EXPECT_GT(live.at("WORLD_POSITION").size(), 400U);
  EXPECT_GT(live.at("COMBINED_MAP").size(), 50U);

  for (const std::string& speed : kPlayed)
    expect_equal(live,
                 computed_live(scratch / "played.lcmlog",
                               {"lcm-logplayer", "-s", speed, "-e", "PICO_.*", log}),
                 "lcm-logplayer at speed " + speed);

  expect_equal(
      live,
      computed_live(scratch / "bridged.lcmlog", {program("pico-bridge"), "--source",
                                                 "log:" + log.string(), "--speed", kBridged}),
      "pico-bridge --source log:");

  expect_equal(live, replayed(log, scratch / "replayed.lcmlog"), "pico-replay");

  shift_channels(log, scratch / "shifted.lcmlog");
  expect_equal(live, replayed(scratch / "shifted.lcmlog", scratch / "shifted_replayed.lcmlog"),
               "pico-replay of the shifted log");
}

}  // namespace
}  // namespace perceptor::test
