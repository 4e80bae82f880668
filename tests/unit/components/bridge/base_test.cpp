#include "components/bridge/sim/base.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/unit/components/bridge/scenes.hpp"

namespace perceptor::sim {
namespace {

constexpr double tick = 0.005;  // [s]

Base square_base(const Position& robot_in_world = {}) {
  BaseParameters parameters;
  parameters.footprint = square_footprint();
  return {parameters, robot_in_world};
}

void drive(Base& base, const Twist& wished, double seconds, const Obstacles& obstacles = {}) {
  for (int i = 0; i < static_cast<int>(std::lround(seconds / tick)); ++i)
    base.advance(wished, tick, obstacles);
}

TEST(Base, SpeedsUpWithItsAcceleration) {
  Base base = square_base();
  drive(base, {0.5, 0.0, 0.0}, 0.25);
  EXPECT_NEAR(base.twist().vx, 0.25, 1e-9);  // 1 m/s^2 for a quarter of a second
  drive(base, {0.0, 0.0, 1.2}, 0.2);
  EXPECT_NEAR(base.twist().va, 0.6, 1e-9);  // 3 rad/s^2 for a fifth
}

TEST(Base, NeverExceedsItsLimits) {
  Base base = square_base();
  drive(base, {3.0, 4.0, -9.0}, 3.0);
  EXPECT_NEAR(base.twist().vx, 0.3, 1e-9);  // in the wished direction, 0.5 m/s in all
  EXPECT_NEAR(base.twist().vy, 0.4, 1e-9);
  EXPECT_NEAR(base.twist().va, -1.2, 1e-9);
}

TEST(Base, DrivesSidewaysAsFarAsItsSpeedSays) {
  Base base = square_base();
  drive(base, {0.0, 0.5, 0.0}, 2.0);
  // Half a second of speeding up covers 0.125 m, and then 1.5 s at 0.5 m/s; to a tick's worth.
  EXPECT_NEAR(base.robot_in_world().y, 0.875, 0.5 * tick);
  EXPECT_NEAR(base.robot_in_world().x, 0.0, 1e-12);
}

TEST(Base, StopsAtAWallThatItMeetsHeadOn) {
  const Obstacles wall{{{{1.0, -5.0}, {1.0, 5.0}}}, {}, {}};
  Base base = square_base();
  drive(base, {0.5, 0.0, 0.0}, 4.0, wall);
  EXPECT_LT(base.robot_in_world().x, 0.8);
  EXPECT_GT(base.robot_in_world().x, 0.8 - (0.5 * tick) - 1e-9);
  EXPECT_TRUE(base.in_collision());
  EXPECT_NEAR(base.twist().vx, 0.0, 0.1);
}

TEST(Base, SlidesAlongAWallThatItMeetsAtAnAngle) {
  const Obstacles wall{{{{1.0, -50.0}, {1.0, 50.0}}}, {}, {}};
  Base base = square_base();
  drive(base, {0.3, 0.3, 0.0}, 6.0, wall);
  EXPECT_LT(base.robot_in_world().x, 0.8);
  EXPECT_GT(base.robot_in_world().y, 1.2);
  EXPECT_TRUE(base.in_collision());
}

TEST(Base, DoesNotTurnIntoAWallBesideIt) {
  // 0.21 m away: the side passes, the corner at 0.28 m does not.
  const Obstacles wall{{{{0.21, -5.0}, {0.21, 5.0}}}, {}, {}};
  Base base = square_base();
  drive(base, {0.0, 0.0, 1.0}, 2.0, wall);
  EXPECT_LT(base.robot_in_world().a, 0.1);
  EXPECT_TRUE(base.in_collision());
}

TEST(Base, StandsStillUnderAPersonAndLeavesWhenTheyHaveGone) {
  const Obstacles person{{}, {{{0.3, 0.0}, 0.2}}, {}};
  Base base = square_base();
  drive(base, {-0.5, 0.0, 0.0}, 1.0, person);
  EXPECT_EQ(base.robot_in_world(), Position{});
  EXPECT_TRUE(base.in_collision());
  drive(base, {-0.5, 0.0, 0.0}, 1.0);
  EXPECT_LT(base.robot_in_world().x, -0.3);
  EXPECT_FALSE(base.in_collision());
}

TEST(Base, LeansAgainstTheWallUntilItDrivesAway) {
  const Obstacles wall{{{{0.5, -5.0}, {0.5, 5.0}}}, {}, {}};
  Base base = square_base();
  drive(base, {0.5, 0.0, 0.0}, 2.0, wall);
  drive(base, {}, 1.0, wall);
  EXPECT_TRUE(base.in_collision());
  drive(base, {-0.5, 0.0, 0.0}, 1.0, wall);
  EXPECT_FALSE(base.in_collision());
}

TEST(Base, SlidesAroundAPerson) {
  const Obstacles person{{}, {{{0.8, 0.1}, 0.25}}, {}};
  Base base = square_base();
  for (int i = 0; i < 2000; ++i) {
    base.advance({0.4, -0.1, 0.0}, tick, person);
    ASSERT_GE(distance(base.robot_in_world().location(), {0.8, 0.1}), 0.449);
  }
  EXPECT_GT(base.robot_in_world().x, 0.8);
}

}  // namespace
}  // namespace perceptor::sim
