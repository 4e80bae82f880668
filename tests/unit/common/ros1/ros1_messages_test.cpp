#include "common/ros1/ros1_messages.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <gmock/gmock.h>

#include "common/ros1/valid_range.hpp"
#include "tests/support/allocation_watch.hpp"
#include "tests/support/ros1_bytes.hpp"

namespace perceptor::ros1 {
namespace {

using perceptor::testing::bytes_of;
using perceptor::testing::Ros1Bytes;
using perceptor::testing::Ros1Odometry;
using perceptor::testing::Ros1Scan;

TEST(Ros1Scan, GivesEveryValueAsItWasSent) {
  Ros1Scan sent;
  sent.ranges = {0.319F, std::numeric_limits<float>::infinity(), -0.004F};
  sent.intensities = {1.0F, 2.0F};
  LaserScan scan;
  ASSERT_EQ(decode(bytes_of(sent), scan), "");
  EXPECT_EQ(scan.header.seq, 7U);
  EXPECT_EQ(scan.header.frame, "pico/laser");
  EXPECT_EQ(scan.angle_min, -1.0F);
  EXPECT_EQ(scan.angle_max, 1.0F);
  EXPECT_EQ(scan.angle_increment, 1.0F);
  EXPECT_EQ(scan.time_increment, 1e-5F);
  EXPECT_EQ(scan.range_min, 0.01F);
  EXPECT_EQ(scan.range_max, 10.0F);
  EXPECT_EQ(scan.ranges, sent.ranges);
}

TEST(Ros1Scan, StampIsRoundedToMicroseconds) {
  const auto utime_of = [](std::uint32_t nanoseconds) {
    Ros1Scan sent;
    sent.seconds = 1'557'240'978;
    sent.nanoseconds = nanoseconds;
    LaserScan scan;
    EXPECT_EQ(decode(bytes_of(sent), scan), "");
    return scan.header.utime;
  };
  EXPECT_EQ(utime_of(561'537'652), 1'557'240'978'561'538);
  EXPECT_EQ(utime_of(561'537'499), 1'557'240'978'561'537);
  EXPECT_EQ(utime_of(999'999'700), 1'557'240'979'000'000);
}

TEST(Ros1Scan, IsTurnedDownWhereverItIsCutOff) {
  const auto whole = bytes_of(Ros1Scan{});
  for (std::size_t size = 0; size < whole.size(); ++size) {
    LaserScan scan;
    EXPECT_EQ(decode(Bytes(whole).first(size), scan), "shorter than its lengths say") << size;
  }
}

TEST(Ros1Scan, IsTurnedDownWithBytesBehindIt) {
  auto bytes = bytes_of(Ros1Scan{});
  bytes.push_back(0);
  LaserScan scan;
  EXPECT_EQ(decode(bytes, scan), "longer than its lengths say");
}

/// No length is believed: nothing is allocated for what is not there.
TEST(Ros1Scan, HostileLengthsCostNothing) {
  for (const std::uint32_t length : {0x40000000U, 0x7FFFFFFFU, 0xFFFFFFFFU}) {
    Ros1Bytes frame;
    frame.add(1U).add(2U).add(3U).add(length);
    Ros1Bytes ranges;
    ranges.header(1, 2, 3, "f");
    for (int i = 0; i < 7; ++i) ranges.add(0.5F);
    ranges.add(length).add(1.0F);
    for (const Ros1Bytes& hostile : {frame, ranges}) {
      LaserScan scan;
      test::forget_allocations();
      EXPECT_EQ(decode(hostile.bytes(), scan), "shorter than its lengths say");
      EXPECT_LT(test::largest_allocation(), 1000U);
    }
  }
}

TEST(Ros1Odometry, GivesThePoseInThePlane) {
  Odometry odometry;
  ASSERT_EQ(decode(bytes_of(Ros1Odometry{}), odometry), "");
  EXPECT_EQ(odometry.header.utime, 100'000'000);
  EXPECT_EQ(odometry.header.frame, "pico/odom");
  EXPECT_EQ(odometry.pose.x, 1.5);
  EXPECT_EQ(odometry.pose.y, -2.5);
  EXPECT_NEAR(odometry.pose.a, 0.5, 1e-15);
}

TEST(Ros1Odometry, HeadingIsWrappedForEitherSignOfTheQuaternion) {
  for (const double heading : {-3.1, -1.0, 0.0, 2.0, 3.1}) {
    for (const double sign : {1.0, -1.0}) {
      Ros1Odometry sent;
      sent.qz = sign * std::sin(0.5 * heading);
      sent.qw = sign * std::cos(0.5 * heading);
      Odometry odometry;
      ASSERT_EQ(decode(bytes_of(sent), odometry), "");
      EXPECT_NEAR(odometry.pose.a, heading, 1e-14);
    }
  }
}

/// Rolled over its own x axis by some degrees, the robot heads where it did.
TEST(Ros1Odometry, ATiltedRobotHasTheHeadingOfItsXAxis) {
  const double heading = 0.7;
  const double roll = 0.1;
  Ros1Odometry sent;
  sent.qx = std::cos(0.5 * heading) * std::sin(0.5 * roll);
  sent.qy = std::sin(0.5 * heading) * std::sin(0.5 * roll);
  sent.qz = std::sin(0.5 * heading) * std::cos(0.5 * roll);
  sent.qw = std::cos(0.5 * heading) * std::cos(0.5 * roll);
  Odometry odometry;
  ASSERT_EQ(decode(bytes_of(sent), odometry), "");
  EXPECT_NEAR(odometry.pose.a, heading, 1e-14);
}

TEST(Ros1Odometry, AQuaternionThatIsNoRotationIsAFault) {
  for (const double w : {0.0, 2.0, std::numeric_limits<double>::quiet_NaN()}) {
    Ros1Odometry sent;
    sent.qz = 0.0;
    sent.qw = w;
    Odometry odometry;
    EXPECT_EQ(decode(bytes_of(sent), odometry), "orientation is no rotation");
  }
}

TEST(Ros1Odometry, IsTurnedDownWhereverItIsCutOff) {
  const auto whole = bytes_of(Ros1Odometry{});
  for (std::size_t size = 0; size < whole.size(); ++size) {
    Odometry odometry;
    EXPECT_EQ(decode(Bytes(whole).first(size), odometry), "shorter than its lengths say") << size;
  }
}

/// 0 +- 0.01, 10 +- 0.01: TU/e's simulators. The real PICO's range_min is a return.
TEST(ValidRange, LeavesOutMissesWithTheirNoise) {
  const ValidRange simulator = valid_range(0.01, 10.0, kMissNoise);
  EXPECT_GT(simulator.min, 0.0101);
  EXPECT_LT(simulator.max, 9.9899);
  EXPECT_GT(simulator.max, 9.98);
  EXPECT_EQ(valid_range(0.023, 60.0, kMissNoise).min, 0.023);
}

TEST(LastAngle, FollowsFromTheBeamsWhereAngleMaxIsOneBeamOff) {
  Ros1Scan sent;
  LaserScan scan;
  ASSERT_EQ(decode(bytes_of(sent), scan), "");
  EXPECT_EQ(last_angle(scan), 1.0);
  scan.angle_max = 2.0F;  // as if there were a fourth beam
  EXPECT_EQ(last_angle(scan), 1.0);
  scan.angle_max = 3.0F;
  EXPECT_EQ(last_angle(scan), std::nullopt);
  scan.ranges = {1.0F};
  EXPECT_EQ(last_angle(scan), -1.0);
}

TEST(Frame, OfOneNameWithAndWithoutASlash) {
  EXPECT_TRUE(is_same_frame("/pico/laser", "pico/laser"));
  EXPECT_FALSE(is_same_frame("pico/laser", "pico/laser2"));
  EXPECT_FALSE(is_same_frame("", "pico/laser"));
}

}  // namespace
}  // namespace perceptor::ros1
