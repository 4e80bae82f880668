#include "common/model/laser_scan.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace perceptor {
namespace {

using testing::ElementsAre;

constexpr double pi = std::numbers::pi;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

LaserScan scan_of(std::vector<double> bearings, std::vector<double> ranges) {
  LaserScan scan;
  scan.valid_min = 0.1;
  scan.valid_max = 10.0;
  scan.bearings = std::move(bearings);
  scan.ranges = std::move(ranges);
  return scan;
}

std::vector<std::size_t> beams(const std::vector<BeamEnd>& ends) {
  std::vector<std::size_t> indices;
  for (const BeamEnd& end : ends) indices.push_back(end.beam);
  return indices;
}

TEST(LaserScan, AReturnIsFinitePositiveAndWithinTheValidRange) {
  const LaserScan scan = scan_of({}, {});
  EXPECT_TRUE(is_return(scan, 0.1));
  EXPECT_TRUE(is_return(scan, 10.0));
  EXPECT_FALSE(is_return(scan, std::nextafter(0.1, 0.0)));
  EXPECT_FALSE(is_return(scan, std::nextafter(10.0, 11.0)));
  EXPECT_FALSE(is_return(scan, 0.0));
  EXPECT_FALSE(is_return(scan, -1.0));
  EXPECT_FALSE(is_return(scan, kInfinity));
  EXPECT_FALSE(is_return(scan, -kInfinity));
  EXPECT_FALSE(is_return(scan, std::nan("")));
}

TEST(LaserScan, ZeroIsNoReturnEvenWhereTheValidRangeBeginsThere) {
  LaserScan scan;
  scan.valid_max = kInfinity;
  EXPECT_FALSE(is_return(scan, 0.0));
  EXPECT_FALSE(is_return(scan, kInfinity));
  EXPECT_TRUE(is_return(scan, 1e-3));
}

TEST(LaserScan, CountsTheBeamsThatReturned) {
  EXPECT_EQ(count_returns(scan_of({}, {})), 0U);
  EXPECT_EQ(count_returns(scan_of({0.0, 0.1, 0.2, 0.3}, {1.0, 0.0, std::nan(""), 2.0})), 2U);
}

TEST(BeamEnds, AreWhereTheBeamsPointFromAMountedLaser) {
  LaserScan scan = scan_of({0.0, 0.5 * pi}, {1.0, 2.0});
  scan.laser_in_robot = {0.3, 0.0, 0.5 * pi};
  const std::vector<BeamEnd> ends = beam_ends(scan);
  ASSERT_EQ(ends.size(), 2U);
  EXPECT_NEAR(distance(ends[0].location, Vector2(0.3, 1.0)), 0.0, 1e-15);
  EXPECT_NEAR(distance(ends[1].location, Vector2(-1.7, 0.0)), 0.0, 1e-15);
  EXPECT_EQ(ends[0].origin, Vector2(0.3, 0.0));
  EXPECT_EQ(ends[1].range, 2.0);
}

TEST(BeamEnds, LeaveOutBeamsThatDidNotReturn) {
  const auto ends = beam_ends(scan_of({0.0, 0.1, 0.2}, {1.0, kInfinity, 3.0}));
  EXPECT_THAT(beams(ends), ElementsAre(0, 2));
  EXPECT_TRUE(beam_ends(scan_of({0.0, 0.1}, {0.0, 0.0})).empty());
  EXPECT_TRUE(beam_ends(scan_of({}, {})).empty());
}

TEST(BeamEnds, AreSortedByBearingWhicheverWayTheLaserTurns) {
  EXPECT_THAT(beams(beam_ends(scan_of({0.2, 0.1, 0.0}, {1.0, 1.0, 1.0}))), ElementsAre(2, 1, 0));
  EXPECT_THAT(beams(beam_ends(scan_of({0.1, -0.2, 0.1}, {1.0, 1.0, 1.0}))), ElementsAre(1, 0, 2))
      << "equal bearings stay in the order of measurement";
}

TEST(BeamEnds, AStraightWallStaysStraightWhileTheRobotTurns) {
  // A wall at x = 2; the robot turns at 1.2 rad/s and drives during a sweep of 20 ms.
  const Twist twist{0.4, -0.1, 1.2};
  LaserScan scan = scan_of({}, {});
  const int count = 101;
  scan.time_increment = 0.02 / (count - 1);
  scan.laser_in_robot = {0.2, 0.05, 0.1};
  for (int i = 0; i < count; ++i) {
    const double bearing = -0.5 + 0.01 * i;
    const Position robot_in_start = move(twist, i * scan.time_increment);
    const Position laser_in_start = compose(robot_in_start, scan.laser_in_robot);
    scan.bearings.push_back(bearing);
    scan.ranges.push_back((2.0 - laser_in_start.x) / std::cos(laser_in_start.a + bearing));
  }
  for (const BeamEnd& end : beam_ends(scan, twist)) {
    EXPECT_NEAR(end.location.x(), 2.0, 1e-14);
    EXPECT_NEAR(distance(end.location, end.origin), end.range, 1e-14);
  }
  const std::vector<BeamEnd> uncorrected = beam_ends(scan);
  EXPECT_GT(std::abs(uncorrected.back().location.x() - 2.0), 0.01) << "the correction matters";
}

}  // namespace
}  // namespace perceptor
