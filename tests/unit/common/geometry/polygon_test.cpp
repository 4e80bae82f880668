#include "common/geometry/polygon.hpp"

#include <algorithm>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace perceptor {
namespace {

const std::vector<Vector2> kSquare = {{0.0, 0.0}, {2.0, 0.0}, {2.0, 2.0}, {0.0, 2.0}};

/// A square with a notch cut in from above, down to (1, 0.5).
const std::vector<Vector2> kNotched = {{0.0, 0.0}, {2.0, 0.0}, {2.0, 2.0}, {1.0, 0.5}, {0.0, 2.0}};

TEST(Polygon, ContainsWhatLiesInside) {
  EXPECT_TRUE(contains(kSquare, {1.0, 1.0}));
  EXPECT_FALSE(contains(kSquare, {3.0, 1.0}));
  EXPECT_FALSE(contains(kSquare, {-1.0, 1.0}));
  EXPECT_FALSE(contains(kSquare, {1.0, 3.0}));
  EXPECT_FALSE(contains(kSquare, {1.0, -1.0}));
}

TEST(Polygon, EdgeAndCornersCountAsInside) {
  for (const Vector2& corner : kSquare) EXPECT_TRUE(contains(kSquare, corner));
  EXPECT_TRUE(contains(kSquare, {1.0, 0.0}));
  EXPECT_TRUE(contains(kSquare, {2.0, 0.7}));
  EXPECT_TRUE(contains(kSquare, {0.3, 2.0}));
  EXPECT_FALSE(contains(kSquare, {2.0 + 1e-8, 0.7}));
}

TEST(Polygon, PointOnASlantedEdgeIsInsideInSpiteOfRounding) {
  const Vector2 from(0.1, 0.2);
  const Vector2 to(1.3, 0.9);
  const std::vector<Vector2> triangle = {from, to, {0.0, 2.0}};
  for (int i = 0; i <= 10; ++i) EXPECT_TRUE(contains(triangle, from + i / 10.0 * (to - from)));
}

TEST(Polygon, OrientationDoesNotMatter) {
  std::vector<Vector2> clockwise = kNotched;
  std::ranges::reverse(clockwise);
  for (double x = -0.25; x < 2.5; x += 0.5)
    for (double y = -0.25; y < 2.5; y += 0.5)
      EXPECT_EQ(contains(kNotched, {x, y}), contains(clockwise, {x, y})) << x << " " << y;
}

TEST(Polygon, NotchIsOutside) {
  EXPECT_FALSE(contains(kNotched, {1.0, 1.5}));
  EXPECT_TRUE(contains(kNotched, {1.0, 0.25}));
  EXPECT_TRUE(contains(kNotched, {0.2, 1.0}));
  EXPECT_FALSE(contains(kNotched, {-1.0, 0.5}));  // level with the notch's tip
}

TEST(Polygon, FewerThanThreeCornersContainNothing) {
  EXPECT_FALSE(contains({}, {0.0, 0.0}));
  EXPECT_FALSE(contains({{0.0, 0.0}}, {0.0, 0.0}));
  EXPECT_FALSE(contains({{0.0, 0.0}, {1.0, 0.0}}, {0.5, 0.0}));
}

TEST(Polygon, PointThatIsNotFiniteIsNowhere) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(contains(kSquare, {nan, 1.0}));
  EXPECT_FALSE(contains(kSquare, {1.0, infinity}));
}

TEST(Polygon, EdgesGoRound) {
  const std::vector<Segment> sides = edges({{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}});
  ASSERT_EQ(sides.size(), 3U);
  EXPECT_EQ(sides[2].a, Vector2(0.0, 1.0));
  EXPECT_EQ(sides[2].b, Vector2(0.0, 0.0));
  EXPECT_TRUE(edges({}).empty());
}

}  // namespace
}  // namespace perceptor
