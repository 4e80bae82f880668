#include "components/bridge/sim/shapes.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "tests/unit/components/bridge/scenes.hpp"

namespace perceptor::sim {
namespace {

TEST(Shapes, BoxTurnedByAQuarterSwapsLengthAndWidth) {
  const Polygon corners = outline({{1.0, 2.0, std::numbers::pi / 2}, 0.8, 0.2});
  for (const Vector2& corner : corners) {
    EXPECT_NEAR(std::abs(corner.x() - 1.0), 0.1, 1e-12);
    EXPECT_NEAR(std::abs(corner.y() - 2.0), 0.4, 1e-12);
  }
}

TEST(Shapes, SegmentsCrossOnlyWithinTheirEnds) {
  const Segment across{{0.0, -1.0}, {0.0, 1.0}};
  EXPECT_TRUE(cross_each_other(across, {{-1.0, 0.0}, {1.0, 0.0}}));
  EXPECT_TRUE(cross_each_other(across, {{0.0, 0.0}, {1.0, 0.0}}));
  EXPECT_FALSE(cross_each_other(across, {{0.1, 0.0}, {1.0, 0.0}}));
  EXPECT_FALSE(cross_each_other(across, {{-1.0, 1.1}, {1.0, 1.1}}));
  EXPECT_FALSE(cross_each_other(across, {{0.0, 0.0}, {0.0, 3.0}}));
}

TEST(Shapes, PolygonTouchesSegmentThatCrossesOrLiesInside) {
  const Polygon robot = square_footprint();
  EXPECT_TRUE(touches(robot, Segment{{-1.0, 0.0}, {1.0, 0.0}}));
  EXPECT_TRUE(touches(robot, Segment{{-0.1, 0.0}, {0.1, 0.05}}));
  EXPECT_FALSE(touches(robot, Segment{{0.21, -1.0}, {0.21, 1.0}}));
}

TEST(Shapes, PolygonTouchesCircleBesideAndInside) {
  const Polygon robot = square_footprint();
  EXPECT_TRUE(touches(robot, Circle{{0.45, 0.0}, 0.26}));
  EXPECT_FALSE(touches(robot, Circle{{0.45, 0.0}, 0.24}));
  EXPECT_TRUE(touches(robot, Circle{{0.0, 0.0}, 0.05}));
  // Nearer to the corner along an axis than it really is.
  EXPECT_FALSE(touches(robot, Circle{{0.4, 0.4}, 0.27}));
}

TEST(Shapes, RadiusIsThatOfTheFarthestCorner) {
  EXPECT_NEAR(radius_of({{0.3, 0.4}, {-0.1, 0.0}}), 0.5, 1e-12);
  EXPECT_EQ(radius_of({}), 0.0);
}

}  // namespace
}  // namespace perceptor::sim
