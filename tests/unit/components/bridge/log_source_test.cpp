#include "components/bridge/log_source.hpp"

#include <filesystem>
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pico/odometry_t.hpp>

#include "components/bridge/bridge_component.hpp"
#include "tests/unit/components/bridge/recorder.hpp"

namespace perceptor {
namespace {

constexpr std::int64_t second = 1'000'000;

std::vector<std::uint8_t> odometry_at(std::int64_t utime) {
  pico::odometry_t odometry{};
  odometry.utime = utime;
  odometry.session = 3;
  std::vector<std::uint8_t> payload(static_cast<std::size_t>(odometry.getEncodedSize()));
  odometry.encode(payload.data(), 0, static_cast<int>(payload.size()));
  return payload;
}

class LogFile : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    file_ = std::filesystem::path(testing::TempDir()) / (std::string(test->name()) + ".log");
  }
  void TearDown() override { std::filesystem::remove(file_); }

  /// Ten odometries a second apart, other channels between them.
  void write_ten() const {
    LogWriter log(file_);
    for (int i = 0; i < 10; ++i) {
      const std::int64_t utime = (1000 + i) * second;
      const auto payload = odometry_at(utime);
      log.write("PICO_ODOMETRY", utime, payload.data(), payload.size());
      log.write("POSITION", utime + 5, payload.data(), payload.size());
      log.write("STATUS_LOCATE", utime + 6, payload.data(), payload.size());
    }
    log.close();
  }

  std::filesystem::path file_;
};

TEST_F(LogFile, PlaysOnlyTheRobotsMessagesByteForByte) {
  write_ten();
  Recorder recorder;
  LogSource source(file_, 0.0, 0.0, recorder.bus);
  while (!source.finished()) source.step(0);
  recorder.drain();
  ASSERT_EQ(recorder.events.size(), 10U);
  for (int i = 0; i < 10; ++i) {
    const auto& event = recorder.events[static_cast<std::size_t>(i)];
    EXPECT_EQ(event.channel, "PICO_ODOMETRY");
    EXPECT_EQ(event.payload, odometry_at((1000 + i) * second));
  }
}

TEST_F(LogFile, IsPacedByTheLogsTimeAndTheSpeed) {
  write_ten();
  Recorder recorder;
  LogSource source(file_, 2.0, 0.0, recorder.bus);
  const std::int64_t start = 123'456;
  std::int64_t next = source.step(start);
  for (int sent = 1; sent < 10; ++sent) {
    recorder.drain();
    EXPECT_EQ(static_cast<int>(recorder.events.size()), sent);
    EXPECT_EQ(next, start + (sent * second / 2));
    EXPECT_EQ(source.step(next - 10), next);  // too early: nothing is sent
    next = source.step(next);
  }
  EXPECT_TRUE(source.finished());
  EXPECT_EQ(recorder.bus.status().message(0, false).outputs.at(0).published, 10);
}

TEST_F(LogFile, CountsWhatFailsTheCheckOfRawBytes) {
  const auto good = odometry_at(second);
  {
    LogWriter log(file_);
    log.write("PICO_ODOMETRY", second, good.data(), good.size() - 1);
    log.write("PICO_ODOMETRY", 2 * second, good.data(), good.size());
    log.write("PICO_UNKNOWN", 3 * second, good.data(), good.size());
    log.close();
  }
  Recorder recorder;
  LogSource source(file_, 0.0, 0.0, recorder.bus);
  while (!source.finished()) source.step(0);
  recorder.drain();
  EXPECT_EQ(recorder.events.size(), 1U);
  EXPECT_EQ(recorder.rejected("PICO_ODOMETRY"), 1);
  EXPECT_EQ(recorder.rejected("log"), 1) << "no channel of ours";
}

TEST_F(LogFile, StopsAfterTheDuration) {
  write_ten();
  Recorder recorder;
  LogSource source(file_, 0.0, 4.0, recorder.bus);
  while (!source.finished()) source.step(0);
  recorder.drain();
  EXPECT_EQ(recorder.events.size(), 4U);
}

TEST_F(LogFile, StampsThatStepBackDoNotHoldItUp) {
  {
    LogWriter log(file_);
    for (const std::int64_t stamp : {10 * second, (10 * second) - 100, 11 * second}) {
      const auto payload = odometry_at(stamp);
      log.write("PICO_ODOMETRY", stamp, payload.data(), payload.size());
    }
    log.close();
  }
  Recorder recorder;
  LogSource source(file_, 1.0, 0.0, recorder.bus);
  EXPECT_EQ(source.step(0), second);
  recorder.drain();
  EXPECT_EQ(recorder.events.size(), 2U);
}

TEST_F(LogFile, DamageIsCountedAndPassedOver) {
  write_ten();
  std::filesystem::resize_file(file_, std::filesystem::file_size(file_) - 3);
  {
    std::fstream file(file_, std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(40);
    file << "rubbish";
  }
  Recorder recorder;
  LogSource source(file_, 0.0, 0.0, recorder.bus);
  while (!source.finished()) source.step(0);
  EXPECT_GE(recorder.rejected("log"), 1);
  EXPECT_THAT(recorder.note(), testing::HasSubstr("messages"));
}

TEST_F(LogFile, WithoutMessagesOfTheRobotIsRefused) {
  {
    LogWriter log(file_);
    log.write("POSITION", second, "x", 1);
    log.close();
  }
  Recorder recorder;
  EXPECT_THROW(LogSource(file_, 1.0, 0.0, recorder.bus), config::Error);
}

TEST_F(LogFile, AStampThatJumpsStallsNothing) {
  const auto message = odometry_at(second);
  {
    LogWriter log(file_);
    for (const std::int64_t stamp : {second, second + 3600 * second, 2 * second, 3 * second})
      log.write("PICO_ODOMETRY", stamp, message.data(), message.size());
    log.close();
  }
  Recorder recorder;
  LogSource source(file_, 1.0, 0.0, recorder.bus);
  for (std::int64_t now = 0; now <= 2 * second; now += second / 10) source.step(now);
  EXPECT_TRUE(source.finished());
  recorder.drain();
  EXPECT_EQ(recorder.events.size(), 4U);
}

TEST_F(LogFile, SaysWhenItFallsBehind) {
  write_ten();
  Recorder recorder;
  LogSource source(file_, 1.0, 0.0, recorder.bus);
  source.step(0);
  source.step(5 * second);  // the second message is four seconds late
  recorder.drain();
  EXPECT_EQ(recorder.events.size(), 2U);
  EXPECT_THAT(recorder.note(), testing::HasSubstr("cannot keep up"));
}

TEST_F(LogFile, IsASourceOfTheBridge) {
  write_ten();
  Recorder recorder;
  BridgeConfig config;
  config.source = "log:" + file_.string();
  config.speed = 0.0;
  BridgeComponent bridge(config, recorder.bus);
  while (!bridge.finished()) bridge.step(0);
  recorder.drain();
  EXPECT_EQ(recorder.count("PICO_ODOMETRY"), 10);
}

TEST_F(LogFile, ThatIsNotThereIsAConfigurationError) {
  Recorder recorder;
  BridgeConfig config;
  config.source = "log:" + file_.string();
  EXPECT_THROW(BridgeComponent(config, recorder.bus), config::Error);
}

}  // namespace
}  // namespace perceptor
