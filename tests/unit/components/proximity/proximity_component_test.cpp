#include "components/proximity/proximity_component.hpp"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <pico/laser_scan_t.hpp>
#include <pico/proximity_t.hpp>

#include "common/bus/channels.hpp"

namespace perceptor {
namespace {

constexpr double kFloat = 1e-6;  // [m], [rad]: ranges travel as floats
constexpr double kPi = 3.14159265358979323846;
constexpr std::size_t kForward = 18;  // the sector [0, 10) degrees

/// The component between two ends of a private in-process bus.
class ProximityComponentTest : public testing::Test {
 protected:
  ProximityComponentTest() {
    listener_.subscribe<pico::proximity_t>(
        channel::proximity, 10,
        [this](const pico::proximity_t& proximity, bool) { received_.push_back(proximity); });
  }

  /// Beams one degree apart, the middle one straight ahead.
  static pico::laser_scan_t scan_of(const std::vector<float>& ranges) {
    pico::laser_scan_t scan{};
    scan.utime = 1'000'000;
    scan.session = 3;
    scan.seq = 5;
    scan.angle_increment = kPi / 180.0;
    scan.angle_max = 0.5 * scan.angle_increment * static_cast<double>(ranges.size() - 1);
    scan.angle_min = -scan.angle_max;
    scan.valid_min = 0.02;
    scan.valid_max = 30.0;
    scan.range_sigma = 0.01;
    scan.ranges = ranges;
    scan.num_ranges = static_cast<std::int32_t>(ranges.size());
    return scan;
  }

  void send(const pico::laser_scan_t& scan) {
    sender_.publish(channel::laser, scan);
    while (lcm_.handleTimeout(0) > 0) {
    }
  }

  std::int64_t counted(const std::string& reason) {
    for (const auto& entry : status_.message(0, false).rejects)
      if (entry.channel == channel::laser && entry.reason == reason) return entry.count;
    return 0;
  }

  lcm::LCM lcm_{"memq://"};
  Status status_{"proximity", 1};
  Status other_status_{"test", 1};
  Bus bus_{lcm_, lcm_, status_};
  Bus sender_{lcm_, lcm_, other_status_};
  Bus listener_{lcm_, lcm_, other_status_};
  ProximityComponent component_{ProximityConfig{}, bus_};
  std::vector<pico::proximity_t> received_;
};

TEST_F(ProximityComponentTest, PublishesOneForEachScan) {
  std::vector<float> ranges(271, 3.0F);
  ranges[140] = 0.3F;  // a thin leg 5 degrees left of straight ahead
  send(scan_of(ranges));
  ASSERT_EQ(received_.size(), 1U);
  const pico::proximity_t& proximity = received_[0];
  EXPECT_EQ(proximity.utime, 1'000'000);
  EXPECT_EQ(proximity.session, 3);
  EXPECT_EQ(proximity.seq, 5);
  EXPECT_EQ(proximity.radius, 0.35);
  ASSERT_EQ(proximity.num_sectors, 36);
  EXPECT_EQ(proximity.too_close[kForward], 1);
  EXPECT_EQ(proximity.contact[kForward], 0);
  EXPECT_EQ(proximity.blind[kForward], 0);
  EXPECT_NEAR(proximity.distances[kForward], 0.3, kFloat);
  EXPECT_NEAR(proximity.bearings[kForward], 5.0 * kPi / 180.0, kFloat);
  EXPECT_NEAR(proximity.nearest_distance, 0.3, kFloat);
  EXPECT_NEAR(proximity.nearest_bearing, 5.0 * kPi / 180.0, kFloat);
  EXPECT_EQ(proximity.blind[0], 1);
  EXPECT_EQ(proximity.distances[0], std::numeric_limits<double>::infinity());
}

TEST_F(ProximityComponentTest, ScanWithoutReturnsIsBlindAllAround) {
  send(scan_of(std::vector<float>(271, 0.0F)));
  ASSERT_EQ(received_.size(), 1U);  // infinite distances pass the check at the other end
  for (const auto blind : received_[0].blind) EXPECT_EQ(blind, 1);
  EXPECT_EQ(received_[0].nearest_distance, std::numeric_limits<double>::infinity());
  EXPECT_EQ(counted("beam without return"), 271);
}

TEST_F(ProximityComponentTest, BodyAgainstTheLaserIsContact) {
  std::vector<float> ranges(271, 3.0F);
  for (std::size_t beam = 120; beam <= 150; ++beam) ranges[beam] = 0.1F;
  send(scan_of(ranges));
  ASSERT_EQ(received_.size(), 1U);
  EXPECT_EQ(received_[0].contact[kForward], 1);
  EXPECT_EQ(received_[0].too_close[kForward], 1);
}

TEST_F(ProximityComponentTest, CountsBeamsOnTheRobotItself) {
  std::vector<float> ranges(271, 3.0F);
  ranges.front() = 0.1F;
  ranges.back() = 0.1F;
  send(scan_of(ranges));
  ASSERT_EQ(received_.size(), 1U);
  EXPECT_EQ(counted("beam on the robot itself"), 2);
  EXPECT_NEAR(received_[0].nearest_distance, 3.0, kFloat);
  EXPECT_EQ(status_.message(0, false).inputs[0].rejected, 0);
}

TEST_F(ProximityComponentTest, LaserPoseOfTheMessageCounts) {
  pico::laser_scan_t scan = scan_of({1.0F});
  scan.laser_in_robot.x = -0.1;
  scan.laser_in_robot.a = kPi / 2.0;
  send(scan);
  ASSERT_EQ(received_.size(), 1U);
  EXPECT_NEAR(received_[0].nearest_distance, std::hypot(1.0, 0.1), kFloat);
  EXPECT_NEAR(received_[0].nearest_bearing, std::atan2(1.0, -0.1), kFloat);
}

TEST_F(ProximityComponentTest, OneBeamAndTenThousandBeams) {
  send(scan_of({1.0F}));
  pico::laser_scan_t large = scan_of(std::vector<float>(10'000, 2.0F));
  large.utime += 25'000;
  large.angle_max = kPi;
  large.angle_min = -kPi;
  large.angle_increment = 2.0 * kPi / 9'999;
  send(large);
  ASSERT_EQ(received_.size(), 2U);
  for (const auto blind : received_[1].blind) EXPECT_EQ(blind, 0);
}

TEST_F(ProximityComponentTest, LivesOnAfterAScanWhoseBeamsDoNotMatchItsAngles) {
  pico::laser_scan_t bad = scan_of(std::vector<float>(271, 3.0F));
  bad.angle_max += 1.0;
  send(bad);
  EXPECT_TRUE(received_.empty());
  send(scan_of(std::vector<float>(271, 3.0F)));
  EXPECT_EQ(received_.size(), 1U);
  EXPECT_EQ(status_.message(0, false).inputs[0].rejected, 1);
}

TEST(ProximityConfigTest, EveryKeyIsRead) {
  ProximityConfig config;
  config::load({.file = {},
                .robot_file = {},
                .overrides = {"radius=0.6", "num_sectors=24", "contact_share=0.5",
                              "min_beams_for_seen=3", "robot.footprint.0.x=0.3"}},
               [&config](config::Fields& fields) { describe(fields, config); });
  EXPECT_EQ(config.proximity.radius, 0.6);
  EXPECT_EQ(config.proximity.num_sectors, 24);
  EXPECT_EQ(config.proximity.contact_share, 0.5);
  EXPECT_EQ(config.proximity.min_beams_for_seen, 3);
  EXPECT_EQ(config.robot.footprint[0].x, 0.3);
}

}  // namespace
}  // namespace perceptor
