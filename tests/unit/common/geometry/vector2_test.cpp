#include "common/geometry/vector2.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "common/geometry/angle.hpp"
#include "tests/unit/common/geometry/random_scene.hpp"

namespace perceptor {
namespace {

constexpr double pi = std::numbers::pi;

TEST(Vector2, DistanceIsSymmetricAndZeroForOnePoint) {
  EXPECT_EQ(distance(Vector2(1.0, 2.0), Vector2(4.0, 6.0)), 5.0);
  EXPECT_EQ(distance(Vector2(4.0, 6.0), Vector2(1.0, 2.0)), 5.0);
  EXPECT_EQ(distance(Vector2(4.0, 6.0), Vector2(4.0, 6.0)), 0.0);
}

TEST(Vector2, AngleOfEachAxis) {
  EXPECT_EQ(angle(Vector2(2.0, 0.0)), 0.0);
  EXPECT_EQ(angle(Vector2(0.0, 2.0)), 0.5 * pi);
  EXPECT_EQ(angle(Vector2(0.0, -2.0)), -0.5 * pi);
}

TEST(Vector2, AngleBackwardIsPlusPiWhateverTheSignOfZero) {
  EXPECT_EQ(angle(Vector2(-1.0, 0.0)), pi);
  EXPECT_EQ(angle(Vector2(-1.0, -0.0)), pi);
  EXPECT_EQ(angle(Vector2(-1.0, -1e-300)), pi);
}

TEST(Vector2, AngleOfTheZeroVectorIsZero) {
  EXPECT_EQ(angle(Vector2(0.0, 0.0)), 0.0);
  EXPECT_EQ(angle(Vector2(-0.0, 0.0)), 0.0);
  EXPECT_EQ(angle(Vector2(-0.0, -0.0)), 0.0);
}

TEST(Vector2, UnitOfTheZeroVectorIsTheZeroVector) {
  EXPECT_EQ(unit(Vector2::Zero()), Vector2::Zero());
}

TEST(Vector2, UnitHasLengthOneHoweverShortOrLongTheVector) {
  for (const double scale : {1e-320, 1e-200, 1e-3, 1.0, 1e200}) {
    const Vector2 v(3.0 * scale, -4.0 * scale);
    // A denormal keeps few digits, so its direction is not asked for here.
    EXPECT_NEAR(length(unit(v)), 1.0, 1e-15) << scale;
  }
}

TEST(Vector2, CrossIsPositiveOnTheLeft) {
  EXPECT_EQ(cross(Vector2(1.0, 0.0), Vector2(0.0, 2.0)), 2.0);
  EXPECT_EQ(cross(Vector2(0.0, 2.0), Vector2(1.0, 0.0)), -2.0);
  EXPECT_EQ(cross(Vector2(1.0, 1.0), Vector2(-2.0, -2.0)), 0.0);
}

TEST(Vector2, PerpendicularIsAQuarterTurnCounterClockwise) {
  EXPECT_EQ(perpendicular(Vector2(1.0, 0.0)), Vector2(0.0, 1.0));
  RandomScene scene;
  for (int i = 0; i < kTries; ++i) {
    const Vector2 v = scene.point();
    EXPECT_EQ(v.dot(perpendicular(v)), 0.0);
    EXPECT_NEAR(angle_difference(angle(v), angle(perpendicular(v))), 0.5 * pi, 1e-14);
  }
}

TEST(Vector2, TransformRotatesFirstAndThenTranslates) {
  const Vector2 moved = transform(Vector2(1.0, 0.0), 0.5 * pi, Vector2(10.0, 20.0));
  EXPECT_NEAR(moved.x(), 10.0, 1e-15);
  EXPECT_NEAR(moved.y(), 21.0, 1e-15);
}

}  // namespace
}  // namespace perceptor
