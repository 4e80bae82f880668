#include "tools/convert/bag_reader.hpp"

#include <deque>
#include <limits>
#include <memory>
#include <utility>

#include <gmock/gmock.h>

#include "tests/support/ros1_bytes.hpp"

namespace perceptor {
namespace {

using testing::bytes_of;
using testing::Ros1Odometry;
using testing::Ros1Scan;

BagMessage scan_message(const Ros1Scan& scan = {}) {
  return {"/pico/laser", "sensor_msgs/LaserScan", bytes_of(scan), {}};
}
BagMessage odometry_message() {
  return {"/pico/odom", "nav_msgs/Odometry", bytes_of(Ros1Odometry{}), {}};
}

BagFile bag_of(std::deque<BagMessage> messages) {
  BagFile bag;
  bag.messages = static_cast<std::int64_t>(messages.size());
  bag.next = [left = std::move(messages)]() mutable -> std::optional<BagMessage> {
    if (left.empty()) return std::nullopt;
    BagMessage message = std::move(left.front());
    left.pop_front();
    return message;
  };
  return bag;
}

TEST(BagReader, GivesScansAndOdometryInTheirOrder) {
  Ros1Scan sent;
  sent.ranges = {0.5F, std::numeric_limits<float>::infinity(), 7.5F};
  BagReader reader(bag_of({odometry_message(), scan_message(sent)}), {});
  const auto first = reader.next();
  ASSERT_TRUE(first && first->odometry);
  EXPECT_EQ(first->odometry->utime, 100'000'000);
  EXPECT_EQ(first->odometry->robot_in_odometry.x, 1.5);
  const auto second = reader.next();
  ASSERT_TRUE(second && second->scan);
  EXPECT_EQ(second->scan->utime, 100'000'000);
  EXPECT_EQ(second->scan->ranges, sent.ranges);
  EXPECT_EQ(second->scan->angle_min, -1.0);
  EXPECT_EQ(second->scan->angle_increment, 1.0);
  EXPECT_EQ(second->scan->time_increment, double{1e-5F});
  EXPECT_EQ(second->scan->valid_min, ros1::kMissNoise);
  EXPECT_NEAR(second->scan->valid_max, 10.0 - ros1::kMissNoise, 1e-9);
  EXPECT_FALSE(reader.next());
  EXPECT_EQ(reader.line(), 2);
  EXPECT_TRUE(reader.notes().empty());
}

TEST(BagReader, SaysWhichTopicsItSkipped) {
  BagReader reader(bag_of({{"/tf", "tf2_msgs/TFMessage", {}, {}},
                           scan_message(),
                           {"/tf", "tf2_msgs/TFMessage", {}, {}},
                           {"/scan", "sensor_msgs/LaserScan", {}, {}}}),
                   {});
  EXPECT_TRUE(reader.next());
  EXPECT_EQ(reader.line(), 2);
  EXPECT_FALSE(reader.next());
  EXPECT_THAT(
      reader.notes(),
      ::testing::ElementsAre("skipped /scan: 1 of sensor_msgs/LaserScan (--laser-topic takes it)",
                             "skipped /tf: 2 of tf2_msgs/TFMessage"));
}

TEST(BagReader, TakesTheTopicsThatAreAskedFor) {
  BagMessage scan = scan_message();
  scan.topic = "/scan";
  BagReader reader(bag_of({scan, odometry_message()}), {"/scan", "/odom"});
  const auto first = reader.next();
  EXPECT_TRUE(first && first->scan);
  EXPECT_FALSE(reader.next());
}

TEST(BagReader, DropsWhatIsNoGoodWithItsReason) {
  BagMessage cut = scan_message();
  cut.bytes.pop_back();
  BagMessage another = scan_message();
  another.type = "sensor_msgs/PointCloud2";
  BagMessage damaged = scan_message();
  damaged.fault = "bad chunk";
  Ros1Scan wrong;
  wrong.angle_max = 30.0F;
  BagReader reader(bag_of({cut, another, damaged, scan_message(wrong)}), {});
  std::vector<std::string> reasons;
  while (const auto parsed = reader.next()) {
    ASSERT_TRUE(parsed->dropped);
    reasons.emplace_back(parsed->dropped->reason);
  }
  EXPECT_THAT(reasons,
              ::testing::ElementsAre("shorter than its lengths say", drop_reason::another_type,
                                     drop_reason::damaged, drop_reason::wrong_angles));
}

}  // namespace
}  // namespace perceptor
