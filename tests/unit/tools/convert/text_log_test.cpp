#include "tools/convert/text_log.hpp"

#include <cmath>
#include <numbers>
#include <string>

#include <gmock/gmock.h>

namespace perceptor {
namespace {

using ::testing::ElementsAre;

/// Of a line that has to be dropped.
std::string reason(const std::string& line) {
  TextLog log;
  const ParsedLine parsed = log.parse(line);
  EXPECT_FALSE(parsed.odometry) << line;
  EXPECT_FALSE(parsed.scan) << line;
  return parsed.dropped ? std::string(parsed.dropped->reason) : "";
}

TEST(TextLog, ReadsOdometry) {
  TextLog log;
  const auto odometry = log.parse("ODOM 1134864629.895182 576.537 0.107 -2.255213").odometry;
  ASSERT_TRUE(odometry);
  EXPECT_EQ(odometry->utime, 1134864629895182);
  EXPECT_EQ(odometry->robot_in_odometry, (Position{576.537, 0.107, -2.255213}));
}

TEST(TextLog, RoundsTimeToMicroseconds) {
  TextLog log;
  EXPECT_EQ(log.parse("ODOM 0.0000014 0 0 0").odometry->utime, 1);
  EXPECT_EQ(log.parse("ODOM 0.0000016 0 0 0").odometry->utime, 2);
  EXPECT_EQ(log.parse("ODOM 0 0 0 0").odometry->utime, 0);
}

TEST(TextLog, BringsAHeadingIntoOneTurnAndLeavesOthersAlone) {
  TextLog log;
  const auto heading = [&log](const std::string& a) {
    return log.parse("ODOM 1 0 0 " + a).odometry->robot_in_odometry.a;
  };
  EXPECT_EQ(heading("3.1"), 3.1);
  EXPECT_NEAR(heading("4"), 4.0 - 2.0 * std::numbers::pi, 1e-12);
  EXPECT_EQ(heading("-3.141592653589793"), std::numbers::pi);
}

TEST(TextLog, ReadsAScanWithItsHeader) {
  TextLog log;
  EXPECT_TRUE(log.parse("# scanlog 1").empty());
  EXPECT_TRUE(log.parse("# laser_pose 0.12 -0.1 0.5 (as measured by hand)").empty());
  EXPECT_TRUE(log.parse("# valid_min 0.05").empty());
  EXPECT_TRUE(log.parse("# valid_max 19.99 says the data sheet").empty());
  EXPECT_TRUE(log.parse("").empty());
  const auto scan = log.parse("LASER 2.5 -0.5 0.25 20 3 1 2.5 3\r").scan;
  ASSERT_TRUE(scan);
  EXPECT_EQ(scan->utime, 2'500'000);
  EXPECT_EQ(scan->laser_in_robot, (Position{0.12, -0.1, 0.5}));
  EXPECT_EQ(scan->angle_min, -0.5);
  EXPECT_EQ(scan->angle_increment, 0.25);
  EXPECT_EQ(scan->range_max, 20.0);
  EXPECT_EQ(scan->valid_min, 0.05);
  EXPECT_EQ(scan->valid_max, 19.99);
  EXPECT_THAT(scan->ranges, ElementsAre(1.0F, 2.5F, 3.0F));
  EXPECT_TRUE(scan->bearings.empty());
}

TEST(TextLog, RangesStayAsRecorded) {
  TextLog log;
  const auto scan = log.parse("LASER 0 0 0.1 81.91 7 nan inf -inf 0 -1 81.91 +1e-3").scan;
  ASSERT_TRUE(scan);
  EXPECT_TRUE(std::isnan(scan->ranges[0]));
  EXPECT_EQ(scan->ranges[1], std::numeric_limits<float>::infinity());
  EXPECT_EQ(scan->ranges[2], -std::numeric_limits<float>::infinity());
  EXPECT_EQ(scan->ranges[3], 0.0F);
  EXPECT_EQ(scan->ranges[4], -1.0F);
  EXPECT_EQ(scan->ranges[5], 81.91F);
  EXPECT_EQ(scan->ranges[6], 1e-3F);
}

TEST(TextLog, IrregularBearingsKeepTheirOrder) {
  TextLog log;
  const auto scan = log.parse("LASERA 1 6 3 0.01 0.9 -0.008 0.901 -3.1 0").scan;
  ASSERT_TRUE(scan);
  EXPECT_EQ(scan->range_max, 6.0);
  EXPECT_THAT(scan->bearings, ElementsAre(0.01F, -0.008F, -3.1F));
  EXPECT_THAT(scan->ranges, ElementsAre(0.9F, 0.901F, 0.0F));
}

TEST(TextLog, SaysWhatIsWrongWithALine) {
  EXPECT_EQ(reason("ODOM 1 2 3 4x"), drop_reason::bad_number);
  EXPECT_EQ(reason("ODOM 1 2 3 nan"), drop_reason::bad_number);
  EXPECT_EQ(reason("ODOM 1 2 inf 0"), drop_reason::bad_number);
  EXPECT_EQ(reason("ODOM 1 2 3"), drop_reason::wrong_count);
  EXPECT_EQ(reason("ODOM 1 2 3 4 5"), drop_reason::wrong_count);
  EXPECT_EQ(reason("ODOM -1 2 3 4"), drop_reason::bad_time);
  EXPECT_EQ(reason("ODOM 1e30 2 3 4"), drop_reason::bad_time);
  EXPECT_EQ(reason("LASER 1 0 0.1 20 3 1 2"), drop_reason::wrong_count);
  EXPECT_EQ(reason("LASER 1 0 0.1 20 3 1 2 3 4"), drop_reason::wrong_count);
  EXPECT_EQ(reason("LASER 1 0 0.1 20 0"), drop_reason::wrong_count);
  EXPECT_EQ(reason("LASER 1 0 0.1 20 -3 1 2 3"), drop_reason::wrong_count);
  EXPECT_EQ(reason("LASER 1 0 0.1 20"), drop_reason::wrong_count);
  EXPECT_EQ(reason("LASER 1 0 0.1 20 2.5 1 2"), drop_reason::bad_number);
  EXPECT_EQ(reason("LASER 1 0 0.1 20 99999999999999999999 1"), drop_reason::bad_number);
  EXPECT_EQ(reason("LASER 1 0 0.1 20 2 1 two"), drop_reason::bad_number);
  EXPECT_EQ(reason("LASER 1 nan 0.1 20 2 1 2"), drop_reason::bad_number);
  EXPECT_EQ(reason("LASERA 1 6 2 0.1 1 0.2"), drop_reason::wrong_count);
  EXPECT_EQ(reason("SONAR 1 2 3"), drop_reason::unknown_keyword);
  EXPECT_EQ(reason("laser 1 0 0.1 20 1 1"), drop_reason::unknown_keyword);
  EXPECT_EQ(reason("# laser_pose 0.1 zero 0"), drop_reason::bad_number);
  EXPECT_EQ(reason("# valid_max"), drop_reason::wrong_count);
}

TEST(TextLog, BoundsTheNumberOfBeams) {
  const auto scan_of = [](int n) {
    std::string line = "LASER 1 0 0.0001 20 " + std::to_string(n);
    for (int i = 0; i < n; ++i) line += " 1";
    return line;
  };
  const auto irregular_of = [](int n) {
    std::string line = "LASERA 1 20 " + std::to_string(n);
    for (int i = 0; i < n; ++i) line += " 0.5 1";
    return line;
  };
  EXPECT_TRUE(TextLog().parse(scan_of(10'000)).scan);
  EXPECT_EQ(reason(scan_of(10'001)), drop_reason::too_many_beams);
  EXPECT_TRUE(TextLog().parse(irregular_of(7'000)).scan);
  EXPECT_EQ(reason(irregular_of(7'001)), drop_reason::too_many_beams);
}

TEST(TextLog, AHeaderLineInTheMiddleDoesNotMoveTheLaser) {
  TextLog log;
  log.parse("# laser_pose 0.1 0 0");
  log.parse("ODOM 1 0 0 0");
  EXPECT_TRUE(log.parse("# a remark").empty());
  EXPECT_EQ(log.parse("# laser_pose 0.2 0 0").dropped->reason, drop_reason::late_header);
  EXPECT_EQ(log.parse("LASER 1 0 0.1 20 1 1").scan->laser_in_robot.x, 0.1);
}

}  // namespace
}  // namespace perceptor
