#include "components/locate/locate_component.hpp"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <pico/odometry_t.hpp>
#include <pico/position_t.hpp>

#include "common/bus/channels.hpp"

namespace perceptor {
namespace {

constexpr double kRounding = 1e-9;        // [m], [rad]
constexpr std::int64_t kPeriod = 25'000;  // [us]

/// The component between two ends of a private in-process bus.
class LocateComponentTest : public testing::Test {
 protected:
  LocateComponentTest() {
    listener_.subscribe<pico::position_t>(
        channel::position, 10,
        [this](const pico::position_t& position, bool) { positions_.push_back(position); });
  }

  void send(std::int64_t utime, const Position& robot_in_odometry, std::int64_t session = 1) {
    pico::odometry_t odometry{};
    odometry.utime = utime;
    odometry.session = session;
    odometry.seq = ++sent_;
    odometry.robot_in_odometry = {};
    odometry.robot_in_odometry.x = robot_in_odometry.x;
    odometry.robot_in_odometry.y = robot_in_odometry.y;
    odometry.robot_in_odometry.a = robot_in_odometry.a;
    sender_.publish(channel::odometry, odometry);
    drain();
  }

  void drain() {
    while (lcm_.handleTimeout(0) > 0) {
    }
  }

  std::int64_t counted(const std::string& reason) {
    for (const auto& entry : status_.message(0, false).rejects)
      if (entry.channel == channel::odometry && entry.reason == reason) return entry.count;
    return 0;
  }

  lcm::LCM lcm_{"memq://"};
  Status status_{"locate", 1};
  Status other_status_{"test", 1};
  Bus bus_{lcm_, lcm_, status_};
  Bus sender_{lcm_, lcm_, other_status_};
  Bus listener_{lcm_, lcm_, other_status_};
  LocateComponent component_{LocateConfig{}, bus_};
  std::vector<pico::position_t> positions_;
  std::int64_t sent_ = 0;
};

TEST_F(LocateComponentTest, PublishesOnePositionForEachOdometry) {
  send(1'000'000, {2.0, 1.0, 3.0}, 7);
  send(1'000'000 + kPeriod, {2.0, 1.0, -3.0}, 7);
  ASSERT_EQ(positions_.size(), 2U);
  EXPECT_EQ(positions_[1].utime, 1'000'000 + kPeriod);
  EXPECT_EQ(positions_[1].session, 7);
  EXPECT_EQ(positions_[1].seq, 2);
  EXPECT_EQ(positions_[1].zero_utime, 1'000'000);
  EXPECT_NEAR(positions_[1].zero_in_odometry.x, 2.0, kRounding);
  EXPECT_NEAR(positions_[1].zero_in_odometry.y, 1.0, kRounding);
  EXPECT_NEAR(positions_[1].zero_in_odometry.a, 3.0, kRounding);
  EXPECT_NEAR(positions_[1].robot_in_zero.x, 0.0, kRounding);
  EXPECT_NEAR(positions_[1].robot_in_zero.y, 0.0, kRounding);
  EXPECT_NEAR(positions_[1].robot_in_zero.a, 2.0 * std::acos(-1.0) - 6.0, kRounding);
  EXPECT_EQ(positions_[1].bridged, 0);
}

TEST_F(LocateComponentTest, ReportsABridgedJump) {
  send(1'000'000, {2.0, 1.0, 0.0});
  send(1'000'000 + kPeriod, {2.01, 1.0, 0.0});
  send(1'000'000 + 2 * kPeriod, {2.51, 1.0, 0.0});
  ASSERT_EQ(positions_.size(), 3U);
  EXPECT_NEAR(positions_[2].robot_in_zero.x, 0.01, kRounding);
  EXPECT_NEAR(positions_[2].zero_in_odometry.x, 2.5, kRounding);
  EXPECT_EQ(positions_[2].zero_utime, 1'000'000);
  EXPECT_EQ(positions_[2].bridged, 1);
  EXPECT_EQ(counted("jump bridged"), 1);
  EXPECT_EQ(counted("robot switched on anew, bridged"), 0);
  EXPECT_EQ(status_.message(0, false).note, "jumps of the odometry bridged in this session: 1");
  EXPECT_EQ(status_.message(0, false).inputs[0].rejected, 0);  // the message itself was taken
}

TEST_F(LocateComponentTest, ReportsARobotThatWasSwitchedOnAnew) {
  send(1'000'000, {2.0, 1.0, 0.0});
  send(1'000'000 + kPeriod, {0.0, 0.0, 0.0});
  ASSERT_EQ(positions_.size(), 2U);
  EXPECT_NEAR(positions_[1].robot_in_zero.x, 0.0, kRounding);
  EXPECT_EQ(counted("jump bridged"), 0);
  EXPECT_EQ(counted("robot switched on anew, bridged"), 1);
}

TEST_F(LocateComponentTest, NewSessionHasANewZeroAndNoNote) {
  send(1'000'000, {2.0, 1.0, 0.0}, 1);
  send(1'000'000 + kPeriod, {5.0, 1.0, 0.0}, 1);
  send(500'000, {5.0, 1.0, 0.0}, 2);
  ASSERT_EQ(positions_.size(), 3U);
  EXPECT_EQ(positions_[2].zero_utime, 500'000);
  EXPECT_NEAR(positions_[2].zero_in_odometry.x, 5.0, kRounding);
  EXPECT_EQ(positions_[2].bridged, 0);
  EXPECT_EQ(status_.message(0, false).note, "");
}

TEST_F(LocateComponentTest, TimeThatStepsBackFarBeginsAnewInTheSameSession) {
  send(10'000'000, {2.0, 1.0, 0.0});
  send(1'000'000, {3.0, 1.0, 0.0});
  ASSERT_EQ(positions_.size(), 2U);
  EXPECT_EQ(positions_[1].zero_utime, 1'000'000);
  EXPECT_NEAR(positions_[1].robot_in_zero.x, 0.0, kRounding);
}

TEST_F(LocateComponentTest, TimeThatStepsBackALittleIsDropped) {
  send(1'000'000, {2.0, 1.0, 0.0});
  send(900'000, {2.0, 1.0, 0.0});
  send(1'000'000, {2.0, 1.0, 0.0});
  EXPECT_EQ(positions_.size(), 1U);
  EXPECT_EQ(status_.message(0, false).inputs[0].rejected, 2);
}

TEST_F(LocateComponentTest, LivesOnAfterBadMessages) {
  send(1'000'000, {std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0});
  const std::string noise = "no message at all";
  lcm_.publish(channel::odometry, noise.data(), static_cast<unsigned>(noise.size()));
  drain();
  EXPECT_TRUE(positions_.empty());
  send(1'000'000 + kPeriod, {1.0, 0.0, 0.0});
  EXPECT_EQ(positions_.size(), 1U);
  EXPECT_EQ(status_.message(0, false).inputs[0].rejected, 2);
}

TEST(LocateConfigTest, EveryKeyIsRead) {
  LocateConfig config;
  config::load({.file = {},
                .robot_file = {},
                .overrides = {"max_speed=1", "distance_slack=0.1", "max_turn_rate=2",
                              "heading_slack=0.2", "origin_radius=0.3", "origin_heading=0.4"}},
               [&config](config::Fields& fields) { describe(fields, config); });
  EXPECT_EQ(config.zero_frame.max_speed, 1.0);
  EXPECT_EQ(config.zero_frame.distance_slack, 0.1);
  EXPECT_EQ(config.zero_frame.max_turn_rate, 2.0);
  EXPECT_EQ(config.zero_frame.heading_slack, 0.2);
  EXPECT_EQ(config.zero_frame.origin_radius, 0.3);
  EXPECT_EQ(config.zero_frame.origin_heading, 0.4);
}

}  // namespace
}  // namespace perceptor
