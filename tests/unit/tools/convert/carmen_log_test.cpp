#include "tools/convert/carmen_log.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include <gmock/gmock.h>

namespace perceptor {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr double kDegree = std::numbers::pi / 180.0;

std::string front_laser(int beams, const std::string& poses) {
  std::string line = "FLASER " + std::to_string(beams);
  for (int i = 0; i < beams; ++i) line.append(" ").append(std::to_string(i));
  return line.append(" ").append(poses).append(" 5.5 host 0.1");
}

TEST(CarmenLog, ReadsOdometry) {
  CarmenLog log;
  const auto odometry = log.parse("ODOM 1 2 0.5 0.3 0.1 0 976052857.071116 pippo 0.99").odometry;
  ASSERT_TRUE(odometry);
  EXPECT_EQ(odometry->utime, 976052857071116);
  EXPECT_EQ(odometry->robot_in_odometry, (Position{1.0, 2.0, 0.5}));
}

TEST(CarmenLog, ReadsAFrontLaserWithItsOdometry) {
  CarmenLog log;
  // The robot looks along y; the laser sits 0.2 m in front of its centre.
  const ParsedLine parsed = log.parse(front_laser(3,
                                                  "1 2.2 1.5707963267948966 "
                                                  "1 2 1.5707963267948966"));
  ASSERT_TRUE(parsed.scan);
  ASSERT_TRUE(parsed.odometry);
  EXPECT_EQ(parsed.scan->utime, 5'500'000);
  EXPECT_EQ(parsed.odometry->utime, 5'500'000);
  EXPECT_NEAR(parsed.scan->laser_in_robot.x, 0.2, 1e-12);
  EXPECT_NEAR(parsed.scan->laser_in_robot.y, 0.0, 1e-12);
  EXPECT_NEAR(parsed.scan->laser_in_robot.a, 0.0, 1e-12);
  EXPECT_EQ(parsed.odometry->robot_in_odometry, (Position{1.0, 2.0, 1.5707963267948966}));
  EXPECT_THAT(parsed.scan->ranges, ElementsAre(0.0F, 1.0F, 2.0F));
  EXPECT_EQ(parsed.scan->range_max, 80.0);
}

TEST(CarmenLog, KnowsASicksAnglesByItsNumberOfBeams) {
  const auto angles = [](int beams) {
    CarmenLog log;
    const auto scan = log.parse(front_laser(beams, "0 0 0 0 0 0")).scan.value();
    return std::array{scan.angle_min / kDegree, scan.angle_increment / kDegree};
  };
  EXPECT_THAT(angles(180), ElementsAre(-90.0, 1.0));
  EXPECT_THAT(angles(181), ElementsAre(-90.0, 1.0));
  EXPECT_THAT(angles(361), ElementsAre(-90.0, 0.5));
  EXPECT_THAT(angles(401), ElementsAre(-50.0, 0.25));
  EXPECT_THAT(angles(91), ElementsAre(-90.0, 2.0));
  EXPECT_EQ(angles(1)[0], -90.0);
}

TEST(CarmenLog, ReadsARobotLaser) {
  CarmenLog log;
  const std::string line =
      "ROBOTLASER1 0 -1.570796 3.14 0.5 80.0 0.01 0 3 1.5 2.5 81.91 2 7 8 "
      "3.1 4 0.25 3 4 0.25 0.1 0.2 0.3 0.4 0.5 1134864642.914187 b21 0.43";
  const ParsedLine parsed = log.parse(line);
  ASSERT_TRUE(parsed.scan);
  EXPECT_EQ(parsed.scan->utime, 1134864642914187);
  EXPECT_EQ(parsed.scan->angle_min, -1.570796);
  EXPECT_EQ(parsed.scan->angle_increment, 0.5);
  EXPECT_EQ(parsed.scan->range_max, 80.0);
  EXPECT_THAT(parsed.scan->ranges, ElementsAre(1.5F, 2.5F, 81.91F));
  EXPECT_NEAR(parsed.scan->laser_in_robot.x, 0.1 * std::cos(0.25), 1e-12);
  EXPECT_NEAR(parsed.scan->laser_in_robot.y, -0.1 * std::sin(0.25), 1e-12);
  ASSERT_TRUE(parsed.odometry);
  EXPECT_EQ(parsed.odometry->robot_in_odometry, (Position{3.0, 4.0, 0.25}));
  EXPECT_THAT(log.notes(), ElementsAre(HasSubstr("no ODOM lines")));
}

TEST(CarmenLog, OdometryLinesReplaceThePosesInScanLines) {
  CarmenLog log;
  EXPECT_TRUE(log.parse(front_laser(1, "0 0 0 0 0 0")).odometry);
  EXPECT_TRUE(log.parse("ODOM 1 2 0.5 0 0 0 6").odometry);
  const ParsedLine parsed = log.parse(front_laser(1, "0 0 0 0 0 0"));
  EXPECT_TRUE(parsed.scan);
  EXPECT_FALSE(parsed.odometry);
  EXPECT_THAT(log.notes(), IsEmpty());
}

TEST(CarmenLog, TheLaserStaysWhereTheFirstScanSawIt) {
  CarmenLog log;
  log.parse(front_laser(1, "0.2 0 0 0 0 0"));
  const auto corrected = log.parse(front_laser(1, "7 3 1 0 0 0")).scan;
  EXPECT_EQ(corrected->laser_in_robot, (Position{0.2, 0.0, 0.0}));
  EXPECT_THAT(log.notes(), ::testing::Contains(HasSubstr("1 scans see the laser elsewhere")));
}

TEST(CarmenLog, SaysWhatIsWrongWithALine) {
  const auto reason = [](const std::string& line) {
    CarmenLog log;
    const ParsedLine parsed = log.parse(line);
    EXPECT_FALSE(parsed.scan || parsed.odometry) << line;
    return parsed.dropped ? parsed.dropped->reason : "";
  };
  EXPECT_EQ(reason("ODOM 1 2 0.5 0.3 0.1 0"), drop_reason::wrong_count);
  EXPECT_EQ(reason("ODOM 1 2 0.5 0.3 0.1 x 5"), drop_reason::bad_number);
  EXPECT_EQ(reason("FLASER 2 1 0 0 0 0 0 0 5"), drop_reason::wrong_count);
  EXPECT_EQ(reason("FLASER 1 1 0 0 0 0 0 0 5 host 0.1 more"), drop_reason::wrong_count);
  EXPECT_EQ(reason("FLASER 10001 1"), drop_reason::too_many_beams);
  EXPECT_EQ(reason("ROBOTLASER1 0 0 3.1 0.5 80 0.01 0 1 1 -1 0 0 0"), drop_reason::wrong_count);
  EXPECT_EQ(reason("ROBOTLASER1 0 0 3.1 0.5 80 0.01 0 1 1 0.5 0 0 0"), drop_reason::wrong_count);
  EXPECT_EQ(reason("PARAM robot_width 0.5 nohost 0"), drop_reason::not_converted);
  EXPECT_EQ(reason("NMEAGGA 1 2 3"), drop_reason::not_converted);
  EXPECT_EQ(reason("WHATEVER 1 2 3"), drop_reason::unknown_keyword);
  EXPECT_EQ(reason("# a comment"), "");
  EXPECT_EQ(reason(""), "");
}

}  // namespace
}  // namespace perceptor
