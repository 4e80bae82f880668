/// The recorder lives through a full disk and its own death, and says what that cost.
#include <csignal>
#include <thread>

#include <gtest/gtest.h>

#include "common/bus/bus.hpp"
#include "common/log/event_log.hpp"
#include "tests/process/harness.hpp"

namespace perceptor::test {
namespace {

constexpr const char* kChannel = "SOMEBODY_ELSES";

class RecordTest : public testing::Test {
 protected:
  std::vector<std::string> command(const std::vector<std::string>& before = {}) const {
    std::vector<std::string> words = before;
    for (const std::string& word :
         {program("pico-record").string(), std::string("--file"), log_.string(),
          std::string("--existing"), std::string("append")})
      words.push_back(word);
    return words;
  }

  /// A message in 5 ms, as a busy channel.
  void send(int messages) {
    const std::vector<std::uint8_t> payload(1000, 7);
    for (int i = 0; i < messages; ++i) {
      status_.lcm().publish(kChannel, payload.data(), static_cast<unsigned>(payload.size()));
      status_.lcm().handleTimeout(5);
    }
    sent_ += messages;
  }

  bool has_seen_all() {
    return status_.wait_until(
        [&] { return received(status_.last("record"), "other channels") == sent_; });
  }

  std::int64_t recorded() const {
    LogReader reader(log_);
    std::int64_t messages = 0;
    for (LogEvent event; reader.next(event);) messages += event.channel == kChannel ? 1 : 0;
    EXPECT_TRUE(reader.damage().empty());
    return messages;
  }

  bool says(const std::string& text) {
    return status_.last("record").note.find(text) != std::string::npos;
  }

  std::int64_t lost() { return rejected(status_.last("record"), "record", "could not be written"); }

  ScratchFolder scratch_;
  std::filesystem::path log_ = scratch_ / "drive.lcmlog";
  StatusListener status_;
  std::int64_t sent_ = 0;
};

TEST_F(RecordTest, AFullDiskCostsWholeMessagesIsToldAndIsNotTheEnd) {
  // Its files may grow to 100 kB: to who writes, that is a full disk.
  Process record(command({"prlimit", "--fsize=100000:unlimited"}));
  ASSERT_TRUE(status_.wait_for({"record"}));
  // While messages come: once they have ended, its own STATUS may find room, and all is well.
  while (!says("not recording: cannot write") && sent_ < 700) send(1);
  EXPECT_TRUE(says("not recording: cannot write")) << status_.last("record").note;
  EXPECT_GT(lost(), 0);
  EXPECT_TRUE(status_.last("record").degraded);
  ASSERT_TRUE(has_seen_all());

  ASSERT_EQ(run({"prlimit", "--pid", std::to_string(record.pid()), "--fsize=unlimited"}).exit_code,
            0);
  EXPECT_TRUE(status_.wait_until(
      [&] { return status_.last("record").note.find("not recording") == std::string::npos; }));
  send(50);
  EXPECT_TRUE(has_seen_all());
  EXPECT_EQ(record.stop(), 0);
  EXPECT_GE(recorded(), 50);
  // STATUS_RECORD itself is recorded too, and lost at times: not counted here.
  EXPECT_LE(recorded() + lost() - sent_, 10);
  EXPECT_GE(recorded() + lost(), sent_);
}

TEST_F(RecordTest, OneThatIsKilledGoesOnBehindTheLastWholeMessage) {
  {
    const Process record(command());
    ASSERT_TRUE(status_.wait_for({"record"}));
    send(100);
    ASSERT_TRUE(has_seen_all());
    status_.wait_until([] { return false; }, Seconds(0.3));
    record.signal(SIGKILL);
  }
  const std::int64_t boot = status_.last("record").boot;
  Process record(command());
  ASSERT_TRUE(status_.wait_until([&] { return status_.last("record").boot != boot; }));
  send(100);
  EXPECT_EQ(record.stop(), 0);
  EXPECT_EQ(recorded(), 200);
}

/// LCM counts for each subscription what waits for it, and finds by name what to hand it: a message
/// that came before the subscription is handed to it as well, at the cost of a later one. LCM's
/// test of itself leaves such a message where a process is slow to start. (Over UDP: memq:// counts
/// as late as it hands on.)
TEST(ARecordersBus, HandsOnTheFirstMessageAlsoBehindLcmsTestOfItself) {
  constexpr const char* kItself = "LCM_SELF_TEST";
  const auto arrives = [] { std::this_thread::sleep_for(Seconds(0.2)); };
  lcm::LCM lcm;
  lcm_subscribe(
      lcm.getUnderlyingLCM(), kItself, [](const lcm_recv_buf_t*, const char*, void*) {}, nullptr);
  lcm.publish(kItself, "", 0);
  arrives();
  Status status("record", 1);
  Bus bus(lcm, lcm, status);
  std::vector<std::string> heard;
  bus.subscribe_all([&](const Bus::Anything& message) -> std::string_view {
    heard.push_back(message.channel);
    return {};
  });
  for (const char* channel : {"FIRST", "SECOND"}) lcm.publish(channel, "", 0);
  arrives();
  while (lcm.handleTimeout(0) > 0) {
  }
  EXPECT_EQ(heard, (std::vector<std::string>{"FIRST", "SECOND"}));
}

TEST_F(RecordTest, ItsOwnLastWordIsInTheRecording) {
  Process record(command());
  ASSERT_TRUE(status_.wait_for({"record"}));
  EXPECT_EQ(record.stop(), 0);
  const Finished check = run({program("pico-logcheck"), log_});
  EXPECT_EQ(check.exit_code, 0) << check.output;
}

TEST_F(RecordTest, DoesNotBeginOnADiskWithTooLittleRoom) {
  std::vector<std::string> words = command();
  words.insert(words.end(), {"--set", "min_free=1e9"});
  const Finished refused = run(words, Seconds(5));
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_NE(refused.output.find("MB of its disk are free"), std::string::npos) << refused.output;
}

}  // namespace
}  // namespace perceptor::test
