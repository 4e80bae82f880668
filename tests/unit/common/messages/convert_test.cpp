#include "common/messages/convert.hpp"

#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/message_samples.hpp"

namespace perceptor {
namespace {

using messages::encoded;
using messages::sample;
using messages::validate;
using testing::DoubleNear;
using testing::ElementsAre;
using testing::Pointwise;

TEST(Convert, APoseKeepsItsNumbersAndGetsItsHeadingWrapped) {
  const Position robot_in_zero{1.0, -2.0, 3.0};
  EXPECT_EQ(to_model(to_message(robot_in_zero)), robot_in_zero);
  pico::pose_t pose = to_message({1.0, 2.0, 0.0});
  pose.a = -std::numbers::pi;
  EXPECT_EQ(to_model(pose).a, std::numbers::pi);
  pose.a = 7.0;
  EXPECT_NEAR(to_model(pose).a, 7.0 - 2.0 * std::numbers::pi, 1e-15);
}

TEST(Convert, ARegularScanGetsItsBearings) {
  const pico::laser_scan_t message = sample<pico::laser_scan_t>();
  const LaserScan scan = to_model(message);
  EXPECT_EQ(scan.laser_in_robot, (Position{0.3, 0.0, 0.0}));
  EXPECT_EQ(scan.time_increment, 2e-5);
  EXPECT_EQ(scan.valid_min, 0.1);
  EXPECT_EQ(scan.valid_max, 10.0);
  EXPECT_EQ(scan.range_sigma, 0.01);
  EXPECT_THAT(scan.bearings,
              Pointwise(DoubleNear(1e-15), std::vector<double>{-0.2, -0.1, 0.0, 0.1, 0.2}));
  EXPECT_EQ(scan.ranges.back(), 2.5);
  EXPECT_EQ(scan.size(), 5U);
}

TEST(Convert, AnIrregularScanKeepsItsBearings) {
  auto message = sample<pico::laser_scan_t>();
  message.angle_min = message.angle_max = message.angle_increment = 0.0;
  message.bearings = {0.5F, 0.25F, -0.5F, 1.0F, 1.5F};
  message.num_bearings = 5;
  ASSERT_EQ(validate(message), "");
  EXPECT_THAT(to_model(message).bearings, ElementsAre(0.5, 0.25, -0.5, 1.0, 1.5));
}

TEST(Convert, AScanOfOneBeam) {
  auto message = sample<pico::laser_scan_t>();
  message.ranges = {1.5F};
  message.num_ranges = 1;
  message.angle_min = message.angle_max = 0.4;
  message.angle_increment = 0.0;
  ASSERT_EQ(validate(message), "");
  EXPECT_THAT(to_model(message).bearings, ElementsAre(0.4));
}

TEST(Convert, AMapComesBackAsItWas) {
  const pico::map_t message = sample<pico::map_t>();
  const Map map = to_model(message);
  pico::map_t again = message;
  set_map(again, map);
  EXPECT_EQ(encoded(again), encoded(message)) << "every field, to the last bit";
  EXPECT_EQ(find_broken_reference(map), "");
}

TEST(Convert, AModelComesBackAsItWas) {
  Map map;
  add_segment(map, {Vector2(0.0, 1.0), Vector2(2.0, 3.0)}, ObjectType::test, "name");
  Point& point = map.points[1];
  point.covariance = Eigen::Matrix2d{{3.0, 0.5}, {0.5, 2.0}};
  point.property = PointProperty::concave;
  point.method = CornerMethod::intersection;
  point.radius = 0.3;
  point.weight = 4.0;
  point.projection = 0;
  Object& object = map.objects[0];
  object.id = 12;
  object.draw_type = DrawType::points;
  object.connection = Connection::closed;
  object.colour = 0x123456;
  object.remove = true;
  object.is_new = false;
  object.free_side = FreeSide::right;
  object.support = 33;
  object.weight = 5.0;
  object.confidence = 0.5;
  object.line_covariance = Eigen::Matrix2d{{1.0, 0.25}, {0.25, 0.5}};
  object.first_seen = 1000;
  object.last_seen = 2000;
  object.reason = "because";

  const Map again = to_model(make_map_message("robot", map));

  EXPECT_EQ(again.points[0].location, map.points[0].location);
  EXPECT_FALSE(again.points[0].covariance.has_value());
  const Point& point_again = again.points[1];
  EXPECT_EQ(point_again.covariance, point.covariance);
  EXPECT_EQ(point_again.property, point.property);
  EXPECT_EQ(point_again.method, point.method);
  EXPECT_EQ(point_again.radius, point.radius);
  EXPECT_EQ(point_again.weight, point.weight);
  EXPECT_EQ(point_again.connected, kNone);
  EXPECT_EQ(point_again.projection, 0);
  EXPECT_EQ(point_again.parents, point.parents);
  const Object& object_again = again.objects[0];
  EXPECT_EQ(object_again.id, object.id);
  EXPECT_EQ(object_again.name, object.name);
  EXPECT_EQ(object_again.type, object.type);
  EXPECT_EQ(object_again.draw_type, object.draw_type);
  EXPECT_EQ(object_again.connection, object.connection);
  EXPECT_EQ(object_again.colour, object.colour);
  EXPECT_EQ(object_again.remove, object.remove);
  EXPECT_EQ(object_again.is_new, object.is_new);
  EXPECT_EQ(object_again.free_side, object.free_side);
  EXPECT_EQ(object_again.support, object.support);
  EXPECT_EQ(object_again.weight, object.weight);
  EXPECT_EQ(object_again.confidence, object.confidence);
  EXPECT_EQ(object_again.line_covariance, object.line_covariance);
  EXPECT_EQ(object_again.first_seen, object.first_seen);
  EXPECT_EQ(object_again.last_seen, object.last_seen);
  EXPECT_EQ(object_again.reason, object.reason);
  EXPECT_EQ(object_again.points, object.points);
}

TEST(Convert, SetMapReplacesTheMapAndNothingElse) {
  auto message = sample<pico::map_t>();
  set_map(message, Map{});
  EXPECT_EQ(message.num_points, 0);
  EXPECT_EQ(message.num_objects, 0);
  EXPECT_TRUE(message.points.empty());
  EXPECT_TRUE(message.objects.empty());
  EXPECT_EQ(message.utime, 1'500'000);
  EXPECT_EQ(message.map_id, 9);
}

TEST(Convert, AFreshMapMessageSaysThatItKnowsNothing) {
  const pico::map_t message = make_map_message("local", Map{});
  EXPECT_EQ(message.frame, "local");
  EXPECT_EQ(message.part, 0);
  EXPECT_EQ(message.parts, 1);
  EXPECT_LT(message.robot_in_local_covariance[0], 0.0);
  EXPECT_EQ(message.unobservable, 0);
  EXPECT_EQ(validate(message), "");
}

}  // namespace
}  // namespace perceptor
