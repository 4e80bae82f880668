#include "components/bridge/bridge_component.hpp"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pico/laser_scan_t.hpp>
#include <pico/map_t.hpp>
#include <pico/odometry_t.hpp>
#include <pico/truth_t.hpp>

#include "common/bus/channels.hpp"
#include "components/bridge/sim_messages.hpp"
#include "tests/unit/components/bridge/recorder.hpp"

namespace perceptor {
namespace {

constexpr std::int64_t second = 1'000'000;

BridgeConfig sim_config(const std::string& world = "hospital") {
  BridgeConfig config;
  config.world = world;
  config.config_dir = PERCEPTOR_TEST_CONFIG;
  config.session = 77;
  return config;
}

/// Runs as fast as it can to the end of the duration.
void run(const BridgeConfig& config, Recorder& recorder) {
  BridgeComponent bridge(config, recorder.bus);
  while (!bridge.finished()) {
    bridge.step(0);
    recorder.drain();
  }
}

/// Calls as the runner does, when it is asked to, until `end` or until it has finished.
void run_until(BridgeComponent& bridge, Recorder& recorder, std::int64_t& now, std::int64_t end) {
  while (now < end && !bridge.finished()) {
    now = std::max(now, bridge.step(now));
    recorder.drain();
  }
}

TEST(Bridge, PublishesWhatASimulatedSecondsMeasures) {
  BridgeConfig config = sim_config();
  config.speed = 0.0;
  config.duration = 2.0;
  Recorder recorder;
  run(config, recorder);
  EXPECT_EQ(recorder.count(channel::odometry), 101);
  EXPECT_EQ(recorder.count(channel::laser), 80);
  EXPECT_EQ(recorder.count(channel::truth), 80);
  EXPECT_EQ(recorder.count(channel::world), 3);
  EXPECT_EQ(recorder.events.front().channel, channel::world);
}

TEST(Bridge, StampsCountFromZeroInOneSession) {
  BridgeConfig config = sim_config();
  config.speed = 0.0;
  config.duration = 1.0;
  Recorder recorder;
  run(config, recorder);
  std::int64_t seq = 0;
  for (const auto& scan : recorder.messages<pico::laser_scan_t>(channel::laser)) {
    EXPECT_EQ(scan.seq, seq);
    EXPECT_EQ(scan.session, 77);
    EXPECT_EQ(scan.utime, second + (seq * 25'000));
    ++seq;
  }
  const auto scans = recorder.messages<pico::laser_scan_t>(channel::laser);
  const auto truths = recorder.messages<pico::truth_t>(channel::truth);
  for (std::size_t i = 0; i < scans.size(); ++i) EXPECT_EQ(stamp_of(scans[i]), stamp_of(truths[i]));
}

TEST(Bridge, EverythingPublishedIsValid) {
  BridgeConfig config = sim_config("hospital_hard");
  config.speed = 0.0;
  config.duration = 1.0;
  Recorder recorder;
  run(config, recorder);
  for (const auto& scan : recorder.messages<pico::laser_scan_t>(channel::laser)) {
    EXPECT_EQ(messages::validate(scan), "");
    EXPECT_EQ(scan.num_ranges, 1000);
    EXPECT_NEAR(scan.time_increment * 999.0, 0.02, 1e-12);
    EXPECT_EQ(scan.range_sigma, config.robot.laser.range_sigma);
    EXPECT_EQ(scan.valid_max, config.robot.laser.valid_max);
  }
  for (const auto& odometry : recorder.messages<pico::odometry_t>(channel::odometry))
    EXPECT_EQ(messages::validate(odometry), "");
  for (const auto& truth : recorder.messages<pico::truth_t>(channel::truth)) {
    EXPECT_EQ(messages::validate(truth), "");
    EXPECT_EQ(truth.num_movers, 5);
    EXPECT_EQ(truth.num_doors, 7);
  }
  for (const auto& world : recorder.messages<pico::map_t>(channel::world)) {
    EXPECT_EQ(messages::validate(world), "");
    EXPECT_LT(world.getEncodedSize(), 60'000);
  }
}

TEST(Bridge, WorldTellsWallsCabinetsDoorsAndBoxes) {
  BridgeConfig config = sim_config();
  config.speed = 0.0;
  config.duration = 0.1;
  Recorder recorder;
  run(config, recorder);
  const auto worlds = recorder.messages<pico::map_t>(channel::world);
  ASSERT_EQ(worlds.size(), 1U);
  EXPECT_EQ(worlds[0].frame, "world");
  int shut = 0;
  int open = 0;
  int boxes = 0;
  for (const auto& object : worlds[0].objects) {
    EXPECT_EQ(object.num_points, 2);
    if (object.type == pico::map_object_t::STATIC_OBSTACLE) ++boxes;
    if (object.type != pico::map_object_t::DOOR) continue;
    shut += object.reason == "shut" ? 1 : 0;
    open += object.reason == "open" ? 1 : 0;
  }
  EXPECT_EQ(shut, 4);  // two shut, one recessed, one waiting for a request
  EXPECT_EQ(open, 3);
  EXPECT_EQ(boxes, 8);
}

TEST(Bridge, AWorldThatIsTooLargeGoesInParts) {
  sim::World world;
  for (int i = 0; i < 400; ++i) world.walls.push_back({{0.0, i * 1.0}, {1.0, i * 1.0}});
  const auto parts = to_messages(world, {});
  ASSERT_EQ(parts.size(), 3U);
  for (const auto& part : parts) {
    EXPECT_EQ(part.parts, 3);
    EXPECT_LT(part.getEncodedSize(), 60'000);
    EXPECT_EQ(messages::validate(part), "");
  }
  EXPECT_EQ(parts[2].part, 2);
  EXPECT_EQ(parts[2].num_objects, 100);
}

TEST(Bridge, SameSeedAndSessionGiveTheSameBytesAtAnySpeed) {
  BridgeConfig config = sim_config("hospital_hard");
  config.duration = 1.0;
  config.speed = 0.0;
  Recorder fast;
  run(config, fast);
  config.speed = 3.0;
  Recorder paced;
  BridgeComponent bridge(config, paced.bus);
  std::int64_t now = 5'000;
  run_until(bridge, paced, now, second);
  ASSERT_TRUE(bridge.finished());
  ASSERT_EQ(fast.events.size(), paced.events.size());
  for (std::size_t i = 0; i < fast.events.size(); ++i) {
    EXPECT_EQ(fast.events[i].channel, paced.events[i].channel);
    EXPECT_EQ(fast.events[i].payload, paced.events[i].payload);
  }
}

TEST(Bridge, AnotherSeedIsAnotherSession) {
  BridgeConfig config = sim_config();
  config.speed = 0.0;
  config.duration = 0.1;
  Recorder first;
  run(config, first);
  config.seed = 5;
  config.session = 0;
  Recorder other;
  run(config, other);
  const auto scan = other.messages<pico::laser_scan_t>(channel::laser).front();
  EXPECT_NE(scan.ranges, first.messages<pico::laser_scan_t>(channel::laser).front().ranges);
  EXPECT_GT(scan.session, 1'600'000'000 * second);  // the wall clock
}

TEST(Bridge, SimulatedTimeFollowsTheClock) {
  BridgeConfig config = sim_config();
  config.speed = 2.0;
  Recorder recorder;
  BridgeComponent bridge(config, recorder.bus);
  std::int64_t now = 1'000;
  run_until(bridge, recorder, now, 1'000 + second);
  // Two simulated seconds, give or take what the last step did.
  EXPECT_NEAR(recorder.count(channel::laser), 79, 2);
  EXPECT_FALSE(bridge.finished());
}

TEST(Bridge, FallsBehindRatherThanBursts) {
  Recorder recorder;
  BridgeComponent bridge(sim_config(), recorder.bus);
  bridge.step(0);
  bridge.step(10 * second);
  recorder.drain();
  EXPECT_LE(recorder.count(channel::odometry), 4);
  std::int64_t now = 10 * second;
  run_until(bridge, recorder, now, 12 * second);
  EXPECT_NEAR(recorder.count(channel::odometry), 101, 4);
  EXPECT_THAT(recorder.note(), testing::HasSubstr("cannot keep up"));
}

class CommandedBridge : public testing::Test {
 protected:
  static BridgeConfig config() {
    BridgeConfig config = sim_config();
    config.drive = sim::Drive::command;
    return config;
  }
  void run(double seconds) {
    run_until(bridge_, recorder_, now_, now_ + static_cast<std::int64_t>(seconds * 1e6));
  }
  void send(const pico::velocity_t& command) {
    recorder_.lcm.publish(channel::velocity, &command);
    recorder_.drain();
  }
  static pico::velocity_t forward() {
    pico::velocity_t command{};
    command.vx = 0.4;
    return command;
  }
  pico::truth_t truth() const { return recorder_.messages<pico::truth_t>(channel::truth).back(); }

  Recorder recorder_;
  BridgeComponent bridge_{config(), recorder_.bus};
  std::int64_t now_ = 0;
};

TEST_F(CommandedBridge, DrivesWhileCommandsComeAndStopsAfterThreeTenths) {
  run(0.2);
  EXPECT_EQ(truth().vx, 0.0);
  for (int i = 0; i < 10; ++i) {
    send(forward());
    run(0.1);
  }
  EXPECT_NEAR(truth().vx, 0.4, 1e-9);
  run(1.0);
  EXPECT_EQ(truth().vx, 0.0);
}

TEST_F(CommandedBridge, CommandThatRestsOnAnOldScanIsOld) {
  run(1.0);
  pico::velocity_t command = forward();
  command.utime = truth().utime - (second / 2);
  command.session = 77;
  send(command);
  run(0.2);
  EXPECT_EQ(truth().vx, 0.0);
  command.utime = truth().utime;
  send(command);
  run(0.2);
  EXPECT_GT(truth().vx, 0.0);
}

TEST_F(CommandedBridge, TurnsDownCommandsOfAnotherSessionAndNonsense) {
  pico::velocity_t command = forward();
  command.session = 76;
  send(command);
  command.session = 77;
  command.vx = std::numeric_limits<double>::quiet_NaN();
  send(command);
  run(0.2);
  EXPECT_EQ(truth().vx, 0.0);
  EXPECT_EQ(recorder_.rejected(channel::velocity), 2);
}

TEST_F(CommandedBridge, OpensTheDoorThatIsAskedFor) {
  pico::open_door_t request{};
  request.door = 6;
  recorder_.lcm.publish(channel::open_door, &request);
  run(3.0);
  EXPECT_EQ(truth().doors[6].open_ratio, 1.0);
  request.door = 1;  // shut for good
  recorder_.lcm.publish(channel::open_door, &request);
  run(0.1);
  EXPECT_EQ(recorder_.rejected(channel::open_door), 1);
  request.door = -1;  // the nearest that can
  recorder_.lcm.publish(channel::open_door, &request);
  run(0.1);
  EXPECT_EQ(recorder_.rejected(channel::open_door), 1);
}

TEST_F(CommandedBridge, SaysAloudInItsStatus) {
  pico::speak_t speech{};
  speech.text = "I am here";
  recorder_.lcm.publish(channel::speak, &speech);
  run(0.1);
  EXPECT_THAT(recorder_.note(), testing::HasSubstr("I am here"));
}

TEST(Bridge, UnknownSourceListsThoseThereAre) {
  BridgeConfig config = sim_config();
  config.source = "rosbag";
  Recorder recorder;
  try {
    const BridgeComponent bridge(config, recorder.bus);
    FAIL() << "took an unknown source";
  } catch (const config::Error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("sim, log:FILE, ros"));
  }
}

TEST(Bridge, ItsConfigurationFileHoldsItsDefaults) {
  BridgeConfig config;
  config.world = "changed";
  config.speed = 9.0;
  config.ros.master = "http://changed:1";
  config.ros.node = "changed";
  config.ros.stale_after = 9.0;
  config.ros.laser = {"/changed", "changed", 0.9, 0.9, 9.0};
  config.ros.odometry = {"/changed", "changed"};
  config.ros.commands = {"/changed", "/changed", "/changed", 9.0};
  config::load({std::filesystem::path(PERCEPTOR_TEST_CONFIG) / "bridge.json", {}, {}},
               [&](config::Fields& fields) { describe(fields, config); });
  BridgeConfig defaults;
  EXPECT_EQ(config::print([&](config::Fields& fields) { describe(fields, config); }),
            config::print([&](config::Fields& fields) { describe(fields, defaults); }));
}

}  // namespace
}  // namespace perceptor
