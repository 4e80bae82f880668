#include "common/geometry/position.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "common/geometry/angle.hpp"
#include "tests/unit/common/geometry/random_scene.hpp"

namespace perceptor {
namespace {

constexpr double pi = std::numbers::pi;

/// Some operations on numbers up to 20, each good to 16 digits.
constexpr double kRounding = 1e-13;

void expect_same(const Position& p, const Position& q) {
  EXPECT_NEAR(p.x, q.x, kRounding);
  EXPECT_NEAR(p.y, q.y, kRounding);
  EXPECT_NEAR(angle_difference(p.a, q.a), 0.0, kRounding);
}

TEST(Position, SumAndDifferenceGoByComponentAndWrapTheHeading) {
  const Position p{1.0, 2.0, 3.0};
  const Position q{10.0, 20.0, 1.0};
  expect_same(p + q, {11.0, 22.0, 4.0 - 2.0 * pi});
  expect_same(q - p, {9.0, 18.0, -2.0});
  expect_same((p + q) - q, p);
  EXPECT_EQ((Position{0.0, 0.0, 0.5 * pi} + Position{0.0, 0.0, 0.5 * pi}).a, pi);
  EXPECT_EQ((Position{0.0, 0.0, -0.5 * pi} - Position{0.0, 0.0, 0.5 * pi}).a, pi);
}

TEST(Position, ComposeTurnsTheSecondIntoTheFrameOfTheFirst) {
  const Position robot_in_world{1.0, 2.0, 0.5 * pi};
  const Position laser_in_robot{0.3, 0.0, 0.1};
  expect_same(compose(robot_in_world, laser_in_robot), {1.0, 2.3, 0.5 * pi + 0.1});
}

TEST(Position, InverseOfAHeadingBackwardIsPlusPi) {
  EXPECT_EQ(inverse({0.0, 0.0, pi}).a, pi);
  expect_same(inverse({2.0, 1.0, pi}), {2.0, 1.0, pi});
}

TEST(Position, ComposingFollowsTheLawsOfAGroup) {
  RandomScene scene;
  const Position identity;
  for (int i = 0; i < kTries; ++i) {
    const Position p = scene.position();
    const Position q = scene.position();
    const Position r = scene.position();
    expect_same(compose(p, identity), p);
    expect_same(compose(identity, p), p);
    expect_same(compose(p, inverse(p)), identity);
    expect_same(compose(inverse(p), p), identity);
    expect_same(inverse(inverse(p)), p);
    expect_same(compose(compose(p, q), r), compose(p, compose(q, r)));
    expect_same(inverse(compose(p, q)), compose(inverse(q), inverse(p)));
  }
}

TEST(Position, RelativeIsTheInverseComposed) {
  RandomScene scene;
  for (int i = 0; i < kTries; ++i) {
    const Position a_in_world = scene.position();
    const Position b_in_world = scene.position();
    const Position b_in_a = relative(a_in_world, b_in_world);
    expect_same(b_in_a, compose(inverse(a_in_world), b_in_world));
    expect_same(compose(a_in_world, b_in_a), b_in_world);
    expect_same(relative(a_in_world, a_in_world), {});
  }
}

TEST(Position, RelativeKeepsItsDigitsFarFromTheOrigin) {
  const Position a_in_world{1e6, 1e6, 1.0};
  const Position b_in_world{1e6 + 0.5, 1e6, 1.0};
  const Position b_in_a = relative(a_in_world, b_in_world);
  EXPECT_NEAR(std::hypot(b_in_a.x, b_in_a.y), 0.5, 1e-15);
}

TEST(Position, TransformOfAPointIsComposeOfItsLocation) {
  RandomScene scene;
  for (int i = 0; i < kTries; ++i) {
    const Position b_in_a = scene.position();
    const Vector2 point_in_b = scene.point();
    const Vector2 point_in_a = transform(b_in_a, point_in_b);
    const Position composed = compose(b_in_a, {point_in_b.x(), point_in_b.y(), 0.0});
    EXPECT_NEAR(distance(point_in_a, composed.location()), 0.0, kRounding);
    EXPECT_NEAR(distance(transform(inverse(b_in_a), point_in_a), point_in_b), 0.0, kRounding);
  }
}

TEST(Position, InterpolateMeetsBothEndsToTheLastDigit) {
  RandomScene scene;
  for (int i = 0; i < kTries; ++i) {
    const Position p = scene.position();
    const Position q = scene.position();
    EXPECT_EQ(interpolate(p, q, 0.0), p);
    EXPECT_EQ(interpolate(p, q, 1.0), q);
    EXPECT_EQ(interpolate(p, p, 0.3), p);
  }
}

TEST(Position, InterpolateTurnsTheShortWayAcrossPi) {
  const Position half = interpolate({0.0, 0.0, 3.0}, {2.0, 4.0, -3.0}, 0.5);
  expect_same(half, {1.0, 2.0, pi});
  const Position quarter = interpolate({0.0, 0.0, 3.0}, {2.0, 4.0, -3.0}, 0.25);
  expect_same(quarter, {0.5, 1.0, 3.0 + 0.25 * (2.0 * pi - 6.0)});
}

TEST(Position, InterpolateExtrapolatesOutside) {
  expect_same(interpolate({0.0, 0.0, 0.0}, {1.0, 2.0, 0.1}, 2.0), {2.0, 4.0, 0.2});
  expect_same(interpolate({0.0, 0.0, 0.0}, {1.0, 2.0, 0.1}, -1.0), {-1.0, -2.0, -0.1});
}

TEST(Position, IsFiniteLooksAtEachComponent) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(is_finite({1.0, 2.0, 3.0}));
  EXPECT_FALSE(is_finite({infinity, 0.0, 0.0}));
  EXPECT_FALSE(is_finite({0.0, std::nan(""), 0.0}));
  EXPECT_FALSE(is_finite({0.0, 0.0, -infinity}));
}

}  // namespace
}  // namespace perceptor
