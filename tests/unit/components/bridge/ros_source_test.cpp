#include "components/bridge/ros_source.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pico/laser_scan_t.hpp>
#include <pico/odometry_t.hpp>
#include <pico/open_door_t.hpp>
#include <pico/speak_t.hpp>
#include <pico/velocity_t.hpp>

#include "common/bus/channels.hpp"
#include "tests/support/ros1_bytes.hpp"
#include "tests/unit/components/bridge/recorder.hpp"

namespace perceptor {
namespace {

using Answer = MasterProbe::Answer;
using testing::bytes_of;
using testing::Ros1Odometry;
using testing::Ros1Scan;

constexpr std::int64_t kSecond = 1'000'000;

/// What a master and a robot would do, and what was asked of them.
struct FakeRos {
  Answer master = Answer::yes;
  bool takes_subscriptions = true;
  bool takes_advertisements = true;
  bool is_alive = true;
  RosLink::Arrived arrived;
  int laser_subscriptions = 0;
  int odometry_subscriptions = 0;
  int advertised = 0;
  std::vector<Twist> driven;
  int doors = 0;
  std::vector<std::string> spoken;
  int last_words = 0;
};

class FakeLink : public RosLink {
 public:
  explicit FakeLink(FakeRos& ros) : ros_(ros) {}
  Answer ask_master(std::int64_t) override { return ros_.master; }
  bool subscribe(Feed feed) override {
    ++(feed == Feed::laser ? ros_.laser_subscriptions : ros_.odometry_subscriptions);
    return ros_.takes_subscriptions;
  }
  bool advertise() override {
    ++ros_.advertised;
    return ros_.takes_advertisements;
  }
  Arrived take_arrived() override { return std::exchange(ros_.arrived, {}); }
  bool is_alive() const override { return ros_.is_alive; }
  int velocity_listeners() const override { return 0; }
  void drive(double vx, double vy, double va) override { ros_.driven.push_back({vx, vy, va}); }
  void open_door() override { ++ros_.doors; }
  void speak(const std::string& text) override { ros_.spoken.push_back(text); }
  void drive_no_more() override { ++ros_.last_words; }

 private:
  FakeRos& ros_;
};

class RosSourceTest : public ::testing::Test {
 protected:
  static BridgeConfig config() {
    BridgeConfig config;
    config.source = "ros";
    return config;
  }

  void run(double seconds) {
    const std::int64_t end = now_ + static_cast<std::int64_t>(seconds * 1e6);
    while (now_ < end) now_ = source_->step(now_);
    recorder_.drain();
  }
  void arrive(const Ros1Scan& scan) {
    ros_.arrived.messages.push_back({RosLink::Feed::laser, bytes_of(scan)});
    run(0.002);
  }
  void arrive(const Ros1Odometry& odometry) {
    ros_.arrived.messages.push_back({RosLink::Feed::odometry, bytes_of(odometry)});
    run(0.002);
  }
  /// Laser and odometry for a while, 40 times a second.
  void robot_works(double seconds) {
    for (int i = 0; i < static_cast<int>(seconds * 40.0); ++i) {
      nanoseconds_ += 25'000'000;
      const auto s = static_cast<std::uint32_t>(nanoseconds_ / 1'000'000'000);
      const auto ns = static_cast<std::uint32_t>(nanoseconds_ % 1'000'000'000);
      Ros1Scan scan;
      scan.seconds = s;
      scan.nanoseconds = ns;
      scan.seq = ++seq_;
      arrive(scan);
      Ros1Odometry odometry;
      odometry.seconds = s;
      odometry.nanoseconds = ns;
      arrive(odometry);
      run(0.021);
    }
  }
  template <class Message>
  void send(const std::string& channel, const Message& message) {
    recorder_.lcm.publish(channel, &message);
    recorder_.drain();
    run(0.002);
  }
  static pico::velocity_t forward() {
    pico::velocity_t command{};
    command.vx = 0.4;
    return command;
  }
  std::int64_t rejected(const std::string& topic, const std::string& reason) {
    const pico::status_t status = recorder_.status.message(0, false);
    for (const auto& entry : status.rejects)
      if (entry.channel == topic && entry.reason == reason) return entry.count;
    return 0;
  }

  Recorder recorder_;
  FakeRos ros_;
  std::unique_ptr<RosSource> source_ =
      std::make_unique<RosSource>(config(), 77, recorder_.bus, std::make_unique<FakeLink>(ros_));
  std::int64_t now_ = kSecond;
  std::int64_t nanoseconds_ = 500'000'000'000;
  std::uint32_t seq_ = 0;
};

TEST_F(RosSourceTest, PublishesAScanValueForValue) {
  Ros1Scan sent;
  sent.nanoseconds = 460;
  sent.ranges = {0.004F, std::numeric_limits<float>::infinity(), 9.991F};
  arrive(sent);
  const auto scans = recorder_.messages<pico::laser_scan_t>(channel::laser);
  ASSERT_EQ(scans.size(), 1U);
  const pico::laser_scan_t& scan = scans[0];
  EXPECT_EQ(scan.utime, 100 * kSecond);
  EXPECT_EQ(scan.session, 77);
  EXPECT_EQ(scan.seq, 0);
  EXPECT_EQ(scan.ranges, sent.ranges);
  EXPECT_EQ(scan.angle_min, -1.0);
  EXPECT_EQ(scan.angle_max, 1.0);
  EXPECT_EQ(scan.angle_increment, 1.0);
  EXPECT_EQ(scan.time_increment, double{1e-5F});
  EXPECT_EQ(scan.range_sigma, Robot{}.laser.range_sigma);
  EXPECT_EQ(scan.valid_min, ros1::kMissNoise);
  EXPECT_NEAR(scan.valid_max, 10.0 - ros1::kMissNoise, 1e-9);
}

TEST_F(RosSourceTest, WhichRangesAreReturnsIsConfiguration) {
  BridgeConfig own = config();
  own.ros.laser.valid_min = 0.2;
  own.ros.laser.valid_max = 8.0;
  Recorder recorder;
  RosSource source(own, 1, recorder.bus, std::make_unique<FakeLink>(ros_));
  ros_.arrived.messages.push_back({RosLink::Feed::laser, bytes_of(Ros1Scan{})});
  source.step(kSecond);
  recorder.drain();
  const auto scan = recorder.messages<pico::laser_scan_t>(channel::laser).at(0);
  EXPECT_EQ(scan.valid_min, 0.2);
  EXPECT_EQ(scan.valid_max, 8.0);
}

TEST_F(RosSourceTest, PublishesOdometryAsItIs) {
  arrive(Ros1Odometry{});
  const auto all = recorder_.messages<pico::odometry_t>(channel::odometry);
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].robot_in_odometry.x, 1.5);
  EXPECT_EQ(all[0].robot_in_odometry.y, -2.5);
  EXPECT_NEAR(all[0].robot_in_odometry.a, 0.5, 1e-15);
}

TEST_F(RosSourceTest, CountsWhatIsNoGoodByItsReason) {
  const auto broken = [&](std::vector<std::uint8_t> bytes) {
    bytes.pop_back();
    ros_.arrived.messages.push_back({RosLink::Feed::laser, std::move(bytes)});
    run(0.002);
  };
  broken(bytes_of(Ros1Scan{}));
  Ros1Scan wrong_angles;
  wrong_angles.angle_max = 30.0F;
  arrive(wrong_angles);
  Ros1Scan no_range;
  no_range.range_max = std::numeric_limits<float>::infinity();
  arrive(no_range);
  arrive(Ros1Scan{});
  arrive(Ros1Scan{});  // the same again
  Ros1Scan earlier;
  earlier.seconds = 99;
  arrive(earlier);
  Ros1Odometry far;
  far.x = std::numeric_limits<double>::quiet_NaN();
  arrive(far);
  EXPECT_EQ(recorder_.count(channel::laser), 1);
  EXPECT_EQ(recorder_.count(channel::odometry), 0);
  EXPECT_EQ(rejected("/pico/laser", "shorter than its lengths say"), 1);
  EXPECT_EQ(rejected("/pico/laser", "number of beams does not match the angles"), 1);
  EXPECT_EQ(rejected("/pico/laser", "valid range out of range"), 1);
  EXPECT_EQ(rejected("/pico/laser", "time stood still"), 1);
  EXPECT_EQ(rejected("/pico/laser", "time stepped back"), 1);
  EXPECT_EQ(rejected("/pico/odom", "robot_in_odometry out of range"), 1);
}

TEST_F(RosSourceTest, TakesOnlyTheFrameThatIsConfigured) {
  BridgeConfig own = config();
  own.ros.laser.frame = "pico/laser";
  Recorder recorder;
  RosSource source(own, 1, recorder.bus, std::make_unique<FakeLink>(ros_));
  Ros1Scan scan;
  for (const char* frame : {"/pico/laser", "pico/laser_of_the_arm"}) {
    scan.frame = frame;
    ++scan.seconds;
    ros_.arrived.messages.push_back({RosLink::Feed::laser, bytes_of(scan)});
    source.step(kSecond);
  }
  recorder.drain();
  EXPECT_EQ(recorder.count(channel::laser), 1);
  EXPECT_EQ(recorder.rejected("/pico/laser"), 1);
}

TEST_F(RosSourceTest, ScansThatNeverCameAreCounted) {
  Ros1Scan scan;
  arrive(scan);
  scan.seq += 3;
  scan.seconds += 1;
  arrive(scan);
  const pico::status_t status = recorder_.status.message(0, false);
  const auto laser =
      std::ranges::find(status.inputs, "/pico/laser", &pico::status_input_t::channel);
  ASSERT_NE(laser, status.inputs.end());
  EXPECT_EQ(laser->missed, 2);
}

TEST_F(RosSourceTest, KeepsAskingForAMasterAndSaysSo) {
  ros_.master = Answer::no;
  run(3.0);
  EXPECT_EQ(ros_.laser_subscriptions, 0);
  EXPECT_THAT(recorder_.note(), ::testing::HasSubstr("does not answer"));
  EXPECT_THAT(recorder_.note(), ::testing::HasSubstr("waiting for /pico/laser, /pico/odom"));
  ros_.master = Answer::yes;
  run(0.6);
  EXPECT_EQ(ros_.laser_subscriptions, 1);
  EXPECT_EQ(ros_.odometry_subscriptions, 1);
  EXPECT_EQ(ros_.advertised, 1);
  EXPECT_THAT(recorder_.note(), ::testing::Not(::testing::HasSubstr("does not answer")));
}

TEST_F(RosSourceTest, SubscribesAnewWhenDataGoesStaleAndTheMasterIsThere) {
  robot_works(2.0);
  EXPECT_EQ(ros_.laser_subscriptions, 1);
  ros_.master = Answer::no;
  run(3.0);
  EXPECT_EQ(ros_.laser_subscriptions, 1) << "roscpp would wait for it";
  EXPECT_THAT(recorder_.note(), ::testing::HasSubstr("nothing on /pico/laser"));
  ros_.master = Answer::yes;
  run(0.6);
  EXPECT_EQ(ros_.laser_subscriptions, 2);
  EXPECT_EQ(ros_.odometry_subscriptions, 2);
  EXPECT_EQ(ros_.advertised, 2);
  EXPECT_THAT(recorder_.note(), ::testing::HasSubstr("nothing on /pico/laser"));
  robot_works(0.5);
  EXPECT_THAT(recorder_.note(), ::testing::Not(::testing::HasSubstr("nothing on")));
}

/// A robot outlives its master: its old connections go on, and no new one could be made.
TEST_F(RosSourceTest, LeavesAloneWhatWorks) {
  robot_works(10.0);
  EXPECT_EQ(ros_.laser_subscriptions, 1);
  for (int i = 0; i < 100; ++i) {
    Ros1Scan scan;
    scan.seconds = 1000 + static_cast<std::uint32_t>(i);
    arrive(scan);
    run(0.05);
  }
  EXPECT_EQ(ros_.laser_subscriptions, 1) << "only the odometry is silent";
  EXPECT_GT(ros_.odometry_subscriptions, 2);
}

TEST_F(RosSourceTest, AMasterThatRefusesIsAskedAgain) {
  ros_.takes_subscriptions = false;
  run(1.2);
  EXPECT_GE(ros_.laser_subscriptions, 2);
  EXPECT_LE(ros_.laser_subscriptions, 4);
}

/// Or the robot could not be stopped, though its measurements come.
TEST_F(RosSourceTest, AdvertisesUntilTheMasterTakesIt) {
  ros_.takes_advertisements = false;
  robot_works(0.3);
  EXPECT_EQ(ros_.advertised, 1);
  robot_works(2.0);
  EXPECT_GE(ros_.advertised, 4);
  ros_.takes_advertisements = true;
  robot_works(0.6);
  const int advertised = ros_.advertised;
  robot_works(2.0);
  EXPECT_EQ(ros_.advertised, advertised);
  EXPECT_EQ(ros_.laser_subscriptions, 1);
}

TEST_F(RosSourceTest, ANodeThatWasShutDownEndsTheBridge) {
  ros_.is_alive = false;
  EXPECT_THROW(source_->step(now_), std::runtime_error);
}

TEST_F(RosSourceTest, CommandsGoToTheRobotWithinItsLimits) {
  run(0.1);
  pico::velocity_t fast = forward();
  fast.vx = 3.0;
  fast.vy = 4.0;
  fast.va = -7.0;
  send(channel::velocity, fast);
  ASSERT_EQ(ros_.driven.size(), 1U);
  EXPECT_NEAR(ros_.driven[0].vx, 0.3, 1e-12);
  EXPECT_NEAR(ros_.driven[0].vy, 0.4, 1e-12);
  EXPECT_EQ(ros_.driven[0].va, -1.2);
  EXPECT_EQ(rejected(channel::velocity, "limited to what the robot may drive"), 1);
  pico::open_door_t door{};
  door.door = -1;
  send(channel::open_door, door);
  EXPECT_EQ(ros_.doors, 1);
  pico::speak_t speech{};
  speech.text = "I am here";
  send(channel::speak, speech);
  EXPECT_THAT(ros_.spoken, ::testing::ElementsAre("I am here"));
}

TEST_F(RosSourceTest, CommandsOfAnotherSessionAreTurnedDown) {
  pico::velocity_t command = forward();
  command.session = 76;
  send(channel::velocity, command);
  EXPECT_TRUE(ros_.driven.empty());
  EXPECT_EQ(recorder_.rejected(channel::velocity), 1);
}

/// By the robot's own clock, which need not be ours.
TEST_F(RosSourceTest, ACommandThatRestsOnAnOldScanIsOld) {
  robot_works(1.0);
  pico::velocity_t command = forward();
  command.session = 77;
  command.utime = (nanoseconds_ / 1000) - 400'000;
  send(channel::velocity, command);
  EXPECT_TRUE(ros_.driven.empty());
  command.utime = nanoseconds_ / 1000;
  send(channel::velocity, command);
  EXPECT_EQ(ros_.driven.size(), 1U);
}

TEST_F(RosSourceTest, TellsANewListenerToStop) {
  run(1.0);
  EXPECT_TRUE(ros_.driven.empty());
  ros_.arrived.velocity_listener = true;
  run(0.002);
  ASSERT_EQ(ros_.driven.size(), 1U);
  EXPECT_EQ(ros_.driven[0].vx, 0.0);
}

TEST_F(RosSourceTest, StopsTheRobotWhenItEnds) {
  source_->stop();
  EXPECT_EQ(ros_.last_words, 1);
  source_.reset();
  EXPECT_EQ(ros_.last_words, 1) << "once is enough";
}

TEST_F(RosSourceTest, StopsTheRobotWhenItFails) {
  source_.reset();  // as when something is thrown
  EXPECT_EQ(ros_.last_words, 1);
}

TEST_F(RosSourceTest, ARobotHasOneSpeedOfTime) {
  BridgeConfig own = config();
  own.speed = 2.0;
  EXPECT_THROW(RosSource(own, 1, recorder_.bus, std::make_unique<FakeLink>(ros_)), config::Error);
}

TEST_F(RosSourceTest, FinishesAfterItsDuration) {
  BridgeConfig own = config();
  own.duration = 2.0;
  Recorder recorder;
  RosSource source(own, 1, recorder.bus, std::make_unique<FakeLink>(ros_));
  source.step(kSecond);
  EXPECT_FALSE(source.finished());
  source.step(3 * kSecond);
  EXPECT_TRUE(source.finished());
}

}  // namespace
}  // namespace perceptor
