#include "components/identify/corner_types.hpp"

#include <gtest/gtest.h>

#include "tests/unit/components/identify/scene.hpp"

namespace perceptor::identify::test {
namespace {

void classify(Map& map, const Vector2& robot = kRobot,
              const CornerTypeParameters& parameters = {}) {
  classify_corners(map, read_walls(map), robot, parameters);
}

/// The wall along x and the wall along y that meet at (1, 1); the robot at the origin is not
/// between them, (2, 2) is.
Map corner(FreeSide along_x, FreeSide along_y) {
  Map map;
  draw(map, {{3, 1}, {1, 1}, {1, 3}});
  map.objects[0].free_side = along_x;
  map.objects[1].free_side = along_y;
  return map;
}

PointProperty type_seen_from(Map map, const Vector2& robot) {
  classify(map, robot);
  EXPECT_EQ(end_point(map, 0, 1).property, end_point(map, 1, 0).property);
  return end_point(map, 0, 1).property;
}

TEST(CornerTypes, RoomCornersAreConcave) {
  Map map;
  draw_ring(map, {{-2, -1}, {2, -1}, {2, 1}, {-2, 1}});
  classify(map);
  for (const Point& point : map.points) EXPECT_EQ(point.property, PointProperty::concave);
}

TEST(CornerTypes, PillarCornersAreConvex) {
  Map map;
  draw_ring(map, {{2, -0.2}, {2, 0.2}, {2.4, 0.2}, {2.4, -0.2}});
  classify(map);
  for (const Point& point : map.points) EXPECT_EQ(point.property, PointProperty::convex);
}

TEST(CornerTypes, DoorwayHasConvexCornersAndLooseEnds) {
  Map map = doorway(0.9);
  classify(map);
  EXPECT_EQ(end_point(map, 0, 1).property, PointProperty::convex);
  EXPECT_EQ(end_point(map, 1, 0).property, PointProperty::convex);
  EXPECT_EQ(end_point(map, 2, 1).property, PointProperty::convex);
  EXPECT_EQ(end_point(map, 0, 0).property, PointProperty::floating);
  EXPECT_EQ(end_point(map, 1, 1).property, PointProperty::floating);
}

TEST(CornerTypes, FreeSidesDecideWhereverTheRobotStands) {
  // Drawn with the walls' order (3,1) -> (1,1) -> (1,3): left is towards the origin.
  const Map outside = corner(FreeSide::left, FreeSide::left);
  const Map inside = corner(FreeSide::right, FreeSide::right);
  for (const Vector2& robot : {Vector2(0, 0), Vector2(2, 2), Vector2(2, 0), Vector2(0, 2)}) {
    EXPECT_EQ(type_seen_from(outside, robot), PointProperty::convex);
    EXPECT_EQ(type_seen_from(inside, robot), PointProperty::concave);
  }
}

TEST(CornerTypes, OneKnownFreeSideIsEnough) {
  for (const Vector2& robot : {Vector2(0, 0), Vector2(2, 2)}) {
    EXPECT_EQ(type_seen_from(corner(FreeSide::left, FreeSide::unknown), robot),
              PointProperty::convex);
    EXPECT_EQ(type_seen_from(corner(FreeSide::unknown, FreeSide::right), robot),
              PointProperty::concave);
  }
}

TEST(CornerTypes, RobotDecidesWhereFreeSidesAreUnknownOrContradict) {
  for (const Map& map :
       {corner(FreeSide::unknown, FreeSide::unknown), corner(FreeSide::left, FreeSide::right)}) {
    EXPECT_EQ(type_seen_from(map, {2, 2}), PointProperty::concave);
    EXPECT_EQ(type_seen_from(map, {0, 0}), PointProperty::convex);
    EXPECT_EQ(type_seen_from(map, {2, 0}), PointProperty::convex);
    EXPECT_EQ(type_seen_from(map, {0, 2}), PointProperty::convex);
  }
}

TEST(CornerTypes, WallsThatGoOnStraightStayConnected) {
  Map map;
  draw(map, {{2, 2}, {0, 2.1}, {-2, 2.05}});  // turns by 0.075 rad
  classify(map);
  EXPECT_EQ(end_point(map, 0, 1).property, PointProperty::connected);
  classify(map, kRobot, {.straight_angle = 0.05});
  EXPECT_NE(end_point(map, 0, 1).property, PointProperty::connected);
}

TEST(CornerTypes, EndOfThinPartitionIsConvex) {
  Map map;
  draw(map, {{3, 1}, {1, 1}, {3, 1}});
  classify(map);
  EXPECT_EQ(end_point(map, 0, 1).property, PointProperty::convex);
}

TEST(CornerTypes, OneFaceSeenTwiceIsNoCorner) {
  Map map;
  draw(map, {{3, 1}, {1, 1}, {3, 1}});
  map.objects[1].free_side = FreeSide::right;
  classify(map);
  EXPECT_EQ(end_point(map, 0, 1).property, PointProperty::connected);
}

TEST(CornerTypes, NearerSideOfAJumpIsConvexUnlessSwitchedOff) {
  Map map = loose_walls(0.9);
  end_point(map, 0, 1).method = CornerMethod::spike;
  classify(map);
  EXPECT_EQ(end_point(map, 0, 1).property, PointProperty::convex);
  EXPECT_EQ(end_point(map, 0, 1).connected, kNone);
  EXPECT_EQ(end_point(map, 1, 0).property, PointProperty::floating);

  Map without = loose_walls(0.9);
  end_point(without, 0, 1).method = CornerMethod::spike;
  classify(without, kRobot, {.jump_is_convex = false});
  EXPECT_EQ(end_point(without, 0, 1).property, PointProperty::floating);
}

TEST(CornerTypes, LoneCornerIsConvexWhereItWasAJump) {
  Map map;
  const Index jump = add_point(map, {1, 0});
  const Index turn = add_point(map, {1, 1});
  map.points[static_cast<std::size_t>(jump)].method = CornerMethod::spike;
  map.points[static_cast<std::size_t>(turn)].method = CornerMethod::vector;
  classify(map);
  EXPECT_EQ(map.points[0].property, PointProperty::convex);
  EXPECT_EQ(map.points[1].property, PointProperty::floating);
}

TEST(CornerTypes, EndWhosePartnerIsNoWallIsFloatingAgain) {
  Map map;
  draw(map, {{3, 1}, {1, 1}});
  const Index lone = add_point(map, {1, 1});
  connect(map, map.objects[0].points[1], lone);
  classify(map);
  EXPECT_EQ(end_point(map, 0, 1).property, PointProperty::floating);
}

}  // namespace
}  // namespace perceptor::identify::test
