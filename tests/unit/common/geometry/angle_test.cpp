#include "common/geometry/angle.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/unit/common/geometry/random_scene.hpp"

namespace perceptor {
namespace {

constexpr double pi = std::numbers::pi;

TEST(WrapAngle, KeepsAnglesThatAreWrapped) {
  for (const double angle : {0.0, 1.0, -1.0, pi, std::nextafter(-pi, 0.0), 1e-300})
    EXPECT_EQ(wrap_angle(angle), angle);
}

TEST(WrapAngle, BothEndsGivePlusPi) {
  EXPECT_EQ(wrap_angle(pi), pi);
  EXPECT_EQ(wrap_angle(-pi), pi);
  EXPECT_NEAR(std::abs(wrap_angle(3.0 * pi)), pi, 1e-14);
  EXPECT_NEAR(wrap_angle(std::nextafter(pi, 4.0)), -pi, 1e-14);
}

TEST(WrapAngle, NanAndInfinityGiveNan) {
  EXPECT_TRUE(std::isnan(wrap_angle(std::nan(""))));
  EXPECT_TRUE(std::isnan(wrap_angle(std::numeric_limits<double>::infinity())));
}

TEST(WrapAngle, IsTheSameDirectionWithinOneTurn) {
  RandomScene scene;
  for (int i = 0; i < kTries; ++i) {
    const double angle = scene.number(-100.0, 100.0);
    const double wrapped = wrap_angle(angle);
    EXPECT_GT(wrapped, -pi);
    EXPECT_LE(wrapped, pi);
    // A tenth of a picoradian: the rounding of 2 pi over some 16 turns.
    EXPECT_NEAR(std::cos(wrapped), std::cos(angle), 1e-13);
    EXPECT_NEAR(std::sin(wrapped), std::sin(angle), 1e-13);
  }
}

TEST(AngleDifference, GoesTheShortWayRound) {
  EXPECT_NEAR(angle_difference(3.0, -3.0), 2.0 * pi - 6.0, 1e-15);
  EXPECT_NEAR(angle_difference(-3.0, 3.0), 6.0 - 2.0 * pi, 1e-15);
  EXPECT_EQ(angle_difference(1.0, 1.0), 0.0);
  EXPECT_EQ(angle_difference(0.5 * pi, -0.5 * pi), pi) << "half a turn is positive";
}

}  // namespace
}  // namespace perceptor
