#include "common/geometry/twist.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "common/geometry/angle.hpp"
#include "tests/unit/common/geometry/random_scene.hpp"

namespace perceptor {
namespace {

constexpr double pi = std::numbers::pi;

void expect_near(const Position& p, const Position& q, double tolerance) {
  EXPECT_NEAR(p.x, q.x, tolerance);
  EXPECT_NEAR(p.y, q.y, tolerance);
  EXPECT_NEAR(angle_difference(p.a, q.a), 0.0, tolerance);
}

TEST(Move, StandsStillInNoTimeAndWithoutSpeed) {
  EXPECT_EQ(move({1.0, 2.0, 3.0}, 0.0), Position{});
  EXPECT_EQ(move({}, 5.0), Position{});
}

TEST(Move, GoesStraightWithoutTurning) {
  expect_near(move({0.5, -0.25, 0.0}, 2.0), {1.0, -0.5, 0.0}, 0.0);
}

TEST(Move, DrivesAQuarterOfACircle) {
  const double radius = 2.0;
  const double rate = 0.5 * pi;
  expect_near(move({radius * rate, 0.0, rate}, 1.0), {radius, radius, 0.5 * pi}, 1e-15);
}

TEST(Move, IsSmoothWhereTurningBegins) {
  // Over one metre, a turn this small moves the end aside by half the turn.
  for (const double rate : {1e-300, 1e-15, 1e-9, 1e-6, 1e-4})
    expect_near(move({1.0, 0.0, rate}, 1.0), {1.0, 0.5 * rate, rate}, 1e-8);
}

TEST(Move, TwoStepsAreOneLongStepAndBackIsTheInverse) {
  RandomScene scene;
  for (int i = 0; i < kTries; ++i) {
    const Twist twist{scene.number(-1.0, 1.0), scene.number(-1.0, 1.0), scene.number(-2.0, 2.0)};
    const double s = scene.number(0.0, 2.0);
    const double t = scene.number(0.0, 2.0);
    expect_near(compose(move(twist, s), move(twist, t)), move(twist, s + t), 1e-14);
    expect_near(move(twist, -t), inverse(move(twist, t)), 1e-14);
  }
}

TEST(Move, FollowsManyShortStraightSteps) {
  const Twist twist{0.5, 0.2, 1.2};
  const int steps = 100'000;
  const double step = 1.0 / steps;
  Position robot_in_start;
  for (int i = 0; i < steps; ++i)
    robot_in_start = compose(robot_in_start, {twist.vx * step, twist.vy * step, twist.va * step});
  // A straight step is off by half its turn: 0.5 m/s * 1.2 rad/s / 2 * step.
  expect_near(robot_in_start, move(twist, 1.0), 1e-5);
}

TEST(TwistBetween, LeadsFromOnePoseToTheOther) {
  RandomScene scene;
  for (int i = 0; i < kTries; ++i) {
    const Position from = scene.position();
    const Position to = scene.position();
    const double seconds = scene.number(0.01, 2.0);
    const Twist twist = twist_between(from, to, seconds);
    // Close to half a turn the path is long: some digits go.
    expect_near(compose(from, move(twist, seconds)), to, 1e-12);
  }
}

TEST(TwistBetween, IsZeroWhereNoTimePasses) {
  for (const double seconds : {0.0, -1.0, std::nan("")}) {
    const Twist twist = twist_between({}, {1.0, 2.0, 3.0}, seconds);
    EXPECT_EQ(twist.vx, 0.0);
    EXPECT_EQ(twist.vy, 0.0);
    EXPECT_EQ(twist.va, 0.0);
  }
}

TEST(TwistBetween, HandlesHalfATurnAndNoTurn) {
  const Twist half_turn = twist_between({}, {0.0, 2.0, pi}, 1.0);
  EXPECT_NEAR(half_turn.vx, pi, 1e-15) << "half a circle of radius one";
  EXPECT_NEAR(half_turn.vy, 0.0, 1e-15);
  const Twist straight = twist_between({1.0, 1.0, 0.5 * pi}, {1.0, 3.0, 0.5 * pi}, 2.0);
  EXPECT_NEAR(straight.vx, 1.0, 1e-15);
  EXPECT_NEAR(straight.vy, 0.0, 1e-15);
  EXPECT_EQ(straight.va, 0.0);
}

}  // namespace
}  // namespace perceptor
