// Messages in, messages out: pairing, stamps, counts, configuration.

#include "components/scan/scan_component.hpp"

#include <gtest/gtest.h>
#include <pico/map_t.hpp>
#include <pico/position_t.hpp>

#include "common/bus/channels.hpp"
#include "common/messages/convert.hpp"
#include "tests/unit/components/scan/scan_scene.hpp"

namespace perceptor {
namespace {

class ScanComponentTest : public testing::Test {
 protected:
  ScanComponentTest() { lcm_.subscribe(channel::current_map, &ScanComponentTest::keep, this); }

  /// The wall stands 2 m in front of the robot.
  void send_scan(std::int64_t utime, std::int64_t seq, float own_beam = 2.0F) {
    pico::laser_scan_t scan{};
    set_stamp(scan, {utime, 7, seq});
    scan.angle_min = -0.5;
    scan.angle_max = 0.5;
    scan.angle_increment = 0.01;
    scan.valid_min = 0.01;
    scan.valid_max = 10.0;
    scan.range_sigma = 0.01;
    scan.num_ranges = 101;
    for (int i = 0; i < 101; ++i)
      scan.ranges.push_back(2.0F / static_cast<float>(std::cos(-0.5 + 0.01 * i)));
    scan.ranges[0] = 0.0F;
    scan.ranges[50] = own_beam;
    lcm_.publish(channel::laser, &scan);
    handle();
  }

  void send_position(std::int64_t utime, std::int64_t seq, double x) {
    pico::position_t position{};
    set_stamp(position, {utime, 7, seq});
    position.zero_utime = 1000;
    position.robot_in_zero.x = x;
    lcm_.publish(channel::position, &position);
    handle();
  }

  const std::vector<pico::map_t>& maps() const { return maps_; }
  Status& status() { return status_; }

  std::int64_t counted(const std::string& reason) {
    for (const pico::status_reject_t& reject : status_.message(0, false).rejects)
      if (reject.reason == reason) return reject.count;
    return 0;
  }

 private:
  void handle() {
    while (lcm_.handleTimeout(0) > 0) {
    }
  }
  void keep(const lcm::ReceiveBuffer* /*buffer*/, const std::string& /*channel*/,
            const pico::map_t* map) {
    maps_.push_back(*map);
  }

  lcm::LCM lcm_{"memq://"};
  Status status_{"scan", 1};
  Bus bus_{lcm_, lcm_, status_};
  ScanComponent component_{ScanConfig{}, bus_};
  std::vector<pico::map_t> maps_;
};

TEST_F(ScanComponentTest, PairsEachScanWithThePositionAtItsTime) {
  send_position(1'000'000, 0, 1.0);
  send_scan(1'010'000, 3);
  EXPECT_TRUE(maps().empty()) << "waits for the position after the scan";
  send_position(1'020'000, 1, 1.2);
  ASSERT_EQ(maps().size(), 1U);
  const pico::map_t& map = maps()[0];
  EXPECT_EQ(map.utime, 1'010'000);
  EXPECT_EQ(map.session, 7);
  EXPECT_EQ(map.seq, 3);
  EXPECT_EQ(map.frame, "robot");
  EXPECT_EQ(map.parts, 1);
  EXPECT_EQ(map.zero_utime, 1000);
  EXPECT_NEAR(map.robot_in_zero.x, 1.1, 1e-9);
  EXPECT_NEAR(map.robot_in_local.x, 1.1, 1e-9);
  EXPECT_LT(map.robot_in_local_covariance[0], 0.0) << "unknown";
  EXPECT_EQ(map.num_objects, 1);
  EXPECT_EQ(map.objects[0].free_side, 1);
}

TEST_F(ScanComponentTest, CountsBeamsThatItLeavesOut) {
  send_position(1'000'000, 0, 0.0);
  send_scan(1'010'000, 0, 0.1F);
  send_position(1'020'000, 1, 0.0);
  EXPECT_EQ(counted("beam without return"), 1);
  EXPECT_EQ(counted("beam on the robot itself"), 1);
}

TEST_F(ScanComponentTest, CountsScansWithoutAPosition) {
  send_scan(1'000'000, 0);
  send_position(1'500'000, 0, 0.0);
  EXPECT_TRUE(maps().empty());
  EXPECT_EQ(counted(std::string(drop_reason::before_first)), 1);
}

TEST(ScanConfig, FileHoldsTheDefaults) {
  ScanConfig defaults;
  ScanConfig read;
  const auto describe_own = [](ScanConfig& config) {
    return [&config](config::Fields& fields) { describe(fields, config); };
  };
  config::load({.file = PERCEPTOR_CONFIG_FILE, .robot_file = {}, .overrides = {}},
               describe_own(read));
  EXPECT_EQ(config::print(describe_own(read)), config::print(describe_own(defaults)));
}

}  // namespace
}  // namespace perceptor
