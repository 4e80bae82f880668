#include "components/identify/hallway.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/unit/components/identify/scene.hpp"

namespace perceptor::identify::test {
namespace {

constexpr double kExact = 1e-9;

/// Two walls, 1.2 m apart:
///
///   x = -2 +-------------------+ 3      ^ y
///                 R                     |
///          +-------------------+        +---> x
Map hallway() {
  Map map;
  draw(map, {{3, 0.6}, {-2, 0.6}});
  draw(map, {{-2, -0.6}, {3, -0.6}});
  return map;
}

Map box(const Vector2& low, const Vector2& high, Map map = hallway()) {
  draw_ring(map, {low, {low.x(), high.y()}, high, {high.x(), low.y()}});
  return map;
}

std::optional<Hallway> hallway_of(const Map& map, const Vector2& robot = kRobot) {
  return find_hallway(read_walls(map), robot);
}

void expect_hallway(const std::optional<Hallway>& found, const Vector2& back, const Vector2& front,
                    double width) {
  ASSERT_TRUE(found);
  EXPECT_NEAR(distance(found->back, back), 0.0, kExact) << found->back.transpose();
  EXPECT_NEAR(distance(found->front, front), 0.0, kExact) << found->front.transpose();
  EXPECT_NEAR(found->width, width, kExact);
}

TEST(Hallway, HasACentreLineAndAWidth) {
  expect_hallway(hallway_of(hallway()), {-2, 0}, {3, 0}, 1.2);
}

TEST(Hallway, CentreLineStaysWhereTheRobotDoesNot) {
  expect_hallway(hallway_of(hallway(), {2.5, 0.3}), {-2, 0}, {3, 0}, 1.2);
}

TEST(Hallway, TurnsWithTheRobot) {
  for (const double turn : {0.4, -1.2, 1.5}) {
    const auto found = hallway_of(perceptor::transform(hallway(), Position{0, 0, turn}));
    expect_hallway(found, transform(Vector2(-2, 0), turn, {0, 0}),
                   transform(Vector2(3, 0), turn, {0, 0}), 1.2);
  }
}

TEST(Hallway, DoorwayInOneSideIsBridged) {
  Map map;
  draw(map, {{3, 0.6}, {-2, 0.6}});
  draw(map, {{-2, -0.6}, {-0.45, -0.6}, {-0.45, -0.8}});
  draw(map, {{0.45, -0.8}, {0.45, -0.6}, {3, -0.6}});
  expect_hallway(hallway_of(map), {-2, 0}, {3, 0}, 1.2);  // the robot is beside the doorway
  expect_hallway(hallway_of(map, {-1.5, 0}), {-2, 0}, {3, 0}, 1.2);
}

TEST(Hallway, SideCorridorIsNotBridged) {
  Map map;
  draw(map, {{5, 0.6}, {-2, 0.6}});
  draw(map, {{-2, -0.6}, {0.5, -0.6}});
  draw(map, {{2.5, -0.6}, {5, -0.6}});
  expect_hallway(hallway_of(map), {-2, 0}, {0.5, 0}, 1.2);
}

TEST(Hallway, IsAsLongAsBothSidesStand) {
  Map map;
  draw(map, {{3, 0.6}, {-1, 0.6}});
  draw(map, {{-2, -0.6}, {1, -0.6}});
  expect_hallway(hallway_of(map), {-1, 0}, {1, 0}, 1.2);
}

TEST(Hallway, TwoPostsOfAGapAreNoSide) {
  Map map;
  draw(map, {{3, 0.6}, {-1, 0.6}});
  draw(map, {{-1, -0.6}, {-0.7, -0.6}});
  draw(map, {{0.7, -0.6}, {1.0, -0.6}});
  draw(map, {{2.2, -0.6}, {2.5, -0.6}});
  EXPECT_FALSE(hallway_of(map));
}

TEST(Hallway, RoomIsNone) {
  Map wide;
  draw_ring(wide, {{2, 1.75}, {-2, 1.75}, {-2, -1.75}, {2, -1.75}});
  EXPECT_FALSE(hallway_of(wide)) << "too wide";
  Map square;
  draw_ring(square, {{1.3, 1.2}, {-1.3, 1.2}, {-1.3, -1.2}, {1.3, -1.2}});
  EXPECT_FALSE(hallway_of(square)) << "too short for its width";
  EXPECT_FALSE(hallway_of(doorway(0.9))) << "one wall";
}

TEST(Hallway, SeenFromItsEndIsNotAroundTheRobot) {
  EXPECT_FALSE(hallway_of(hallway(), {-2.2, 0}));
  expect_hallway(hallway_of(hallway(), {-1.8, 0}), {-2, 0}, {3, 0}, 1.2);
}

TEST(Hallway, NextToOneIsNotInOne) {
  EXPECT_FALSE(hallway_of(hallway(), {0, 1.0}));
  EXPECT_FALSE(hallway_of(hallway(), {0, -0.7}));
}

TEST(Hallway, EndsAtABoxAcross) {
  expect_hallway(hallway_of(box({2, -0.5}, {2.4, 0.5})), {-2, 0}, {2, 0}, 1.2);
  EXPECT_FALSE(hallway_of(box({0.3, -0.5}, {2.6, 0.5}), {1.0, 0})) << "inside it";
  const Map both = box({0.5, -0.5}, {0.7, 0.5}, box({-0.7, -0.5}, {-0.5, 0.5}));
  EXPECT_FALSE(hallway_of(both)) << "too short between two";
}

TEST(Hallway, BoxAtOneSideLeavesIt) {
  expect_hallway(hallway_of(box({1, -0.6}, {1.4, -0.2})), {-2, 0}, {3, 0}, 1.2);
}

TEST(Hallway, WallBetweenTheRobotAndASideIsInTheWay) {
  EXPECT_FALSE(hallway_of(box({-0.2, -0.5}, {0.2, -0.3})));
}

TEST(Hallway, WallsThatLookAwayOrAreNotParallelAreNone) {
  Map away;
  draw(away, {{3, 0.6}, {-2, 0.6}});
  draw(away, {{-2, -0.6}, {3, -0.6}}, FreeSide::right);
  EXPECT_FALSE(hallway_of(away));
  Map unknown;
  draw(unknown, {{3, 0.6}, {-2, 0.6}});
  draw(unknown, {{-2, -0.6}, {3, -0.6}}, FreeSide::unknown);
  EXPECT_FALSE(hallway_of(unknown));
  Map funnel;
  draw(funnel, {{3, 1.2}, {-2, 0.4}});
  draw(funnel, {{-2, -0.6}, {3, -0.6}});
  EXPECT_FALSE(hallway_of(funnel));
}

TEST(Hallway, WidthDecidesAtBothLimits) {
  const auto of_width = [](double width) {
    Map map;
    draw(map, {{4, 0.5 * width}, {-4, 0.5 * width}});
    draw(map, {{-4, -0.5 * width}, {4, -0.5 * width}});
    return hallway_of(map).has_value();
  };
  EXPECT_FALSE(of_width(0.59));
  EXPECT_TRUE(of_width(0.61));
  EXPECT_TRUE(of_width(2.99));
  EXPECT_FALSE(of_width(3.01));
}

TEST(Hallway, NarrowestOfSeveral) {
  Map map = hallway();
  draw(map, {{-1, -0.4}, {2.5, -0.4}});  // a long cupboard before one wall
  expect_hallway(hallway_of(map), {-1, 0.1}, {2.5, 0.1}, 1.0);
}

TEST(Hallway, OrderOfWallsDoesNotMatter) {
  Map map = box({1, -0.6}, {1.4, -0.2});
  draw(map, {{-1, -0.55}, {0.8, -0.56}});
  std::vector<Wall> walls = read_walls(map);
  const auto expected = find_hallway(walls, kRobot);
  std::ranges::reverse(walls);
  const auto found = find_hallway(walls, kRobot);
  ASSERT_TRUE(expected && found);
  EXPECT_EQ(found->back, expected->back);
  EXPECT_EQ(found->front, expected->front);
  EXPECT_EQ(found->width, expected->width);
}

TEST(Hallway, MapWithoutWallsHasNone) { EXPECT_FALSE(hallway_of(Map{})); }

}  // namespace
}  // namespace perceptor::identify::test
