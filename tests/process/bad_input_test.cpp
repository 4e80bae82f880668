/// No message can bring a process down, and each bad one is counted with its reason.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <pico/laser_scan_t.hpp>
#include <pico/map_t.hpp>
#include <pico/odometry_t.hpp>
#include <pico/position_t.hpp>
#include <pico/velocity_t.hpp>

#include "common/bus/bus.hpp"
#include "common/messages/convert.hpp"
#include "tests/process/harness.hpp"
#include "tests/support/sanitized.hpp"

namespace perceptor::test {
namespace {

using Bytes = std::vector<std::uint8_t>;

pico::laser_scan_t scan_of(int beams) {
  pico::laser_scan_t scan{};
  scan.utime = 5'000'000;
  scan.session = 1;
  scan.valid_min = 0.01;
  scan.valid_max = 10.0;
  scan.range_sigma = 0.01;
  scan.angle_min = -2.0;
  scan.angle_max = beams > 1 ? 2.0 : -2.0;
  scan.angle_increment = beams > 1 ? 4.0 / (beams - 1) : 0.0;
  scan.num_ranges = beams;
  scan.ranges.assign(static_cast<std::size_t>(beams), 2.0F);
  return scan;
}

/// A good message with the four bytes at `offset` replaced by a count.
Bytes with_count(Bytes bytes, std::size_t offset, std::uint32_t count) {
  for (std::size_t i = 0; i < 4; ++i)
    bytes.at(offset + i) = static_cast<std::uint8_t>(count >> (24U - 8U * i));
  return bytes;
}

/// What every input has to survive, made from one good message of its own type.
std::vector<Bytes> hostile(const Bytes& good, const Bytes& of_another_type) {
  std::vector<Bytes> messages = {of_another_type, {}, {0x00}, Bytes(40'000, 0xFF)};
  for (const std::size_t keep : {8U, 20U, 33U}) {
    if (keep < good.size()) messages.emplace_back(good.begin(), good.begin() + keep);
  }
  messages.emplace_back(good.begin(), good.end() - 1);
  messages.push_back(good);
  messages.back().push_back(0);
  return messages;
}

class BadInputTest : public testing::Test {
 protected:
  void start(const std::string& component) {
    component_ = component;
    process_ = std::make_unique<Process>(std::vector<std::string>{program("pico-" + component)});
    ASSERT_TRUE(status_.wait_for({component}));
  }

  void send(const std::string& channel, const Bytes& bytes) {
    status_.lcm().publish(channel, bytes.data(), static_cast<unsigned>(bytes.size()));
    ++sent_;
  }
  template <class Message>
  void send(const std::string& channel, const Message& message) {
    send(channel, messages::encode(message));
  }

  /// The STATUS after everything that was sent has been received.
  const pico::status_t& settled(const std::string& channel) {
    EXPECT_TRUE(status_.wait_until([&] { return received(last(), channel) == sent_; }))
        << received(last(), channel) << " of " << sent_;
    return last();
  }
  const pico::status_t& last() { return status_.last(component_); }

  void expect_alive() { EXPECT_EQ(process_->stop(), 0); }

  static std::int64_t rejected_on(const pico::status_t& status, const std::string& channel) {
    for (const auto& input : status.inputs)
      if (input.channel == channel) return input.rejected;
    return -1;
  }

  StatusListener status_;
  std::string component_;
  std::unique_ptr<Process> process_;
  std::int64_t sent_ = 0;
};

struct Input {
  std::string component;
  std::string channel;
  Bytes good;
};

class EveryInputTest : public BadInputTest, public testing::WithParamInterface<Input> {};

TEST_P(EveryInputTest, SurvivesAndCountsWhatIsNoMessageOfItsType) {
  const auto& [component, channel, good] = GetParam();
  start(component);
  for (const Bytes& message : hostile(good, messages::encode(pico::velocity_t{})))
    send(channel, message);
  const std::int64_t bad = sent_;
  send(channel, good);
  EXPECT_EQ(rejected_on(settled(channel), channel), bad);
  expect_alive();
}

pico::map_t empty_map() {
  pico::map_t map = make_map_message("robot", Map{});
  map.utime = 5'000'000;
  return map;
}

INSTANTIATE_TEST_SUITE_P(
    All, EveryInputTest,
    testing::Values(Input{"locate", "PICO_ODOMETRY", messages::encode(pico::odometry_t{})},
                    Input{"proximity", "PICO_LASER", messages::encode(scan_of(1000))},
                    Input{"scan", "PICO_LASER", messages::encode(scan_of(1000))},
                    Input{"scan", "POSITION", messages::encode(pico::position_t{})},
                    Input{"merge", "CURRENT_MAP", messages::encode(empty_map())},
                    Input{"identify", "LOCAL_MAP", messages::encode(empty_map())}),
    [](const auto& which) { return which.param.component + "_" + which.param.channel; });

TEST_F(BadInputTest, HostileCountsOfBeamsAreRejected) {
  start("scan");
  const Bytes good = messages::encode(scan_of(1000));
  // The count of ranges stands before 1000 floats, the count of bearings and none of those.
  const std::size_t count_at = good.size() - 4 - 4000 - 4;
  for (const std::uint32_t count :
       {0xFFFFFFFFU, 0x80000000U, 0x7FFFFFFFU, 0x20000000U, 100'000'000U})
    send("PICO_LASER", with_count(good, count_at, count));
  EXPECT_EQ(rejected_on(settled("PICO_LASER"), "PICO_LASER"), 5);
  EXPECT_TRUE(kSanitized || last().rss_bytes < 16'000'000)
      << "a hostile count must not be allocated: " << last().rss_bytes;
  expect_alive();
}

TEST_F(BadInputTest, ScansOfOneBeamAndOfTenThousandAreTaken) {
  start("proximity");
  auto one = scan_of(1);
  auto many = scan_of(10'000);
  many.utime += 25'000;
  auto too_many = scan_of(10'001);
  too_many.utime += 50'000;
  auto no_beam = scan_of(0);
  no_beam.utime += 75'000;
  auto miscounted = scan_of(1000);
  miscounted.angle_max = 1.0;
  miscounted.utime += 100'000;
  for (const auto& scan : {one, many, too_many, no_beam, miscounted}) send("PICO_LASER", scan);
  const auto& status = settled("PICO_LASER");
  EXPECT_EQ(rejected_on(status, "PICO_LASER"), 3);
  EXPECT_EQ(published(status, "PROXIMITY"), 2);
  expect_alive();
}

TEST_F(BadInputTest, TimeThatStepsBackALittleIsDroppedAndALotBeginsAnew) {
  start("locate");
  pico::odometry_t odometry{};
  const auto at = [&](std::int64_t utime) {
    odometry.utime = utime;
    ++odometry.seq;
    send("PICO_ODOMETRY", odometry);
  };
  at(10'000'000);
  at(9'990'000);
  at(10'000'000);
  at(10'020'000);
  at(1'000'000);
  const auto& status = settled("PICO_ODOMETRY");
  EXPECT_EQ(rejected(status, "PICO_ODOMETRY", "time stepped back"), 1);
  EXPECT_EQ(rejected(status, "PICO_ODOMETRY", "time stood still"), 1);
  EXPECT_EQ(status.inputs.at(0).restarts, 1);
  EXPECT_EQ(published(status, "POSITION"), 3);
  expect_alive();
}

TEST_F(BadInputTest, OdometryThatJumpsOrIsNotANumberIsCounted) {
  start("locate");
  pico::odometry_t odometry{};
  odometry.robot_in_odometry = {3.0, 2.0, 1.0};
  const auto next = [&] {
    odometry.utime += 20'000;
    ++odometry.seq;
    send("PICO_ODOMETRY", odometry);
  };
  next();
  odometry.robot_in_odometry.x = std::numeric_limits<double>::quiet_NaN();
  next();
  odometry.robot_in_odometry.x = 13.0;
  next();
  odometry.robot_in_odometry = {0.0, 0.0, 0.0};
  next();
  const auto& status = settled("PICO_ODOMETRY");
  EXPECT_EQ(rejected_on(status, "PICO_ODOMETRY"), 1);
  EXPECT_EQ(published(status, "POSITION"), 3);
  std::int64_t bridged = 0;
  for (const auto& entry : status.rejects)
    if (entry.reason.find("bridged") != std::string::npos) bridged += entry.count;
  EXPECT_EQ(bridged, 2) << "one jump, one robot switched on anew";
  expect_alive();
}

TEST_F(BadInputTest, BeamsWithoutAReturnAreCountedNotTheScan) {
  start("scan");
  auto scan = scan_of(1000);
  scan.ranges[0] = std::numeric_limits<float>::quiet_NaN();
  scan.ranges[1] = std::numeric_limits<float>::infinity();
  scan.ranges[2] = 0.0F;
  scan.ranges[3] = -1.0F;
  scan.ranges[4] = 81.91F;
  pico::position_t position{};
  position.session = 1;
  position.utime = scan.utime;
  send("POSITION", position);
  sent_ = 0;
  send("PICO_LASER", scan);
  const auto& status = settled("PICO_LASER");
  EXPECT_EQ(rejected_on(status, "PICO_LASER"), 0);
  EXPECT_TRUE(status_.wait_until([&] { return published(last(), "CURRENT_MAP") == 1; }));
  EXPECT_EQ(rejected(last(), "PICO_LASER", "beam without return"), 5);
  expect_alive();
}

}  // namespace
}  // namespace perceptor::test
