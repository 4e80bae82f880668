#include "components/viewer/sensor_items.hpp"

#include <limits>
#include <numbers>

#include <gmock/gmock.h>

namespace perceptor::viewer {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

constexpr double kExact = 1e-9;

TEST(SensorItems, WhereNoBeamReturnedNothingIsSeenAsFree) {
  LaserScan scan;
  scan.laser_in_robot = {0.1, 0.0, 0.0};
  scan.valid_max = 10.0;
  scan.bearings = {-0.5, -0.4, 0.0, 0.4, 0.5};
  scan.ranges = {2.0, 2.0, std::numeric_limits<double>::quiet_NaN(), 2.0, 2.0};
  const std::vector<Item> items = beam_items(scan);
  ASSERT_EQ(items.size(), 3U) << "two fans, and the ends";
  for (const std::size_t fan : {0U, 1U}) {
    EXPECT_EQ(items[fan].mark, Mark::beam_fan);
    EXPECT_EQ(items[fan].points.size(), 3U) << "the laser and two ends";
    EXPECT_EQ(items[fan].points[0], Vector2(0.1, 0.0));
  }
  EXPECT_EQ(items[2].points.size(), 4U);
}

TEST(SensorItems, AScanWithoutReturnsGivesNothing) {
  LaserScan scan;
  scan.bearings = {0.0};
  scan.ranges = {0.0};
  EXPECT_THAT(beam_items(scan), IsEmpty());
}

TEST(SensorItems, SectorsGoRoundFromBehind) {
  std::vector<SectorView> sectors(4);
  sectors[0].blind = true;
  sectors[1].too_close = true;
  sectors[1].distance = 0.2;
  sectors[2].too_close = sectors[2].contact = true;
  const std::vector<Item> items = proximity_items(sectors, 0.5);
  ASSERT_EQ(items.size(), 4U);
  EXPECT_EQ(items[0].mark, Mark::blind_sector);
  EXPECT_EQ(items[1].mark, Mark::too_close);
  EXPECT_THAT(items[1].text, HasSubstr("nearest 0.20 m"));
  EXPECT_EQ(items[2].mark, Mark::contact) << "worse than too close";
  EXPECT_EQ(items[3].mark, Mark::clear_sector);
  EXPECT_NEAR(items[0].points[1].x(), -0.5, kExact);
  EXPECT_NEAR(items[2].points[1].x(), 0.5, kExact);
}

TEST(SensorItems, TheEllipseIsThreeSigmasWide) {
  const Eigen::Matrix2d covariance = Eigen::Vector2d(0.01, 0.0004).asDiagonal();
  const std::optional<Item> ellipse = ellipse_item({1.0, 2.0, 0.0}, covariance);
  ASSERT_TRUE(ellipse);
  double widest = 0.0;
  double highest = 0.0;
  for (const Vector2& point : ellipse->points) {
    widest = std::max(widest, std::abs(point.x() - 1.0));
    highest = std::max(highest, std::abs(point.y() - 2.0));
  }
  EXPECT_NEAR(widest, 0.3, kExact);
  EXPECT_NEAR(highest, 0.06, kExact);
}

TEST(SensorItems, AnUnknownCovarianceHasNoEllipse) {
  EXPECT_FALSE(ellipse_item({}, Eigen::Matrix2d::Zero()));
  EXPECT_FALSE(ellipse_item({}, -Eigen::Matrix2d::Identity()));
  EXPECT_FALSE(
      ellipse_item({}, Eigen::Matrix2d::Constant(std::numeric_limits<double>::infinity())));
}

TEST(SensorItems, TheWayOutPointsOutward) {
  WayOut way_out;
  way_out.found = true;
  way_out.middle = {2.0, 0.0};
  way_out.direction = std::numbers::pi / 2.0;
  way_out.width = 0.9;
  const std::vector<Item> items = way_out_items(way_out);
  ASSERT_EQ(items.size(), 1U);
  EXPECT_NEAR(items[0].points[0].x(), 2.0, kExact);
  EXPECT_GT(items[0].points[0].y(), 0.0) << "outside";
  EXPECT_GT(items[0].points[1].y(), items[0].points[0].y());
  EXPECT_THAT(items[0].text, HasSubstr("0.90 m wide"));
  EXPECT_THAT(way_out_items({}), IsEmpty());
}

}  // namespace
}  // namespace perceptor::viewer
