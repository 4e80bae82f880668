#include "components/merge/sees_through.hpp"

#include <gtest/gtest.h>

namespace perceptor::merge {
namespace {

const Segment kScreen{{0.0, 2.0}, {2.0, 2.0}};
const Vector2 kLaser{1.0, 0.0};

std::optional<Interval> through(const Segment& target, const Segment& screen = kScreen,
                                const Vector2& laser = kLaser) {
  return passed_through(screen, laser, target, {});
}

TEST(SeesThrough, RaysToAWallBehindPassWhereTheyCross) {
  // Twice as far away, the target from x = 0.6 to 1.4 is seen through 0.8 to 1.2.
  const auto piece = through({{0.6, 4.0}, {1.4, 4.0}});
  ASSERT_TRUE(piece);
  EXPECT_NEAR(piece->from, 0.8, 1e-12);
  EXPECT_NEAR(piece->to, 1.2, 1e-12);
}

TEST(SeesThrough, WayOfTheWallsAndSideOfTheLaserDoNotMatter) {
  const auto turned = through({{1.4, 4.0}, {0.6, 4.0}}, {kScreen.b, kScreen.a});
  ASSERT_TRUE(turned);
  EXPECT_NEAR(turned->from, 0.8, 1e-12);
  EXPECT_NEAR(turned->to, 1.2, 1e-12);
  EXPECT_TRUE(through({{0.6, 0.0}, {1.4, 0.0}}, kScreen, {1.0, 4.0}));
}

TEST(SeesThrough, WideTargetIsSeenThroughTheWholeWallButItsMargins) {
  const auto piece = through({{-9.0, 4.0}, {9.0, 4.0}});
  ASSERT_TRUE(piece);
  EXPECT_NEAR(piece->from, 0.1, 1e-12);
  EXPECT_NEAR(piece->to, 1.9, 1e-12);
}

TEST(SeesThrough, TargetInFrontOrJustBehindSaysNothing) {
  EXPECT_FALSE(through({{0.6, 1.0}, {1.4, 1.0}}));
  EXPECT_FALSE(through({{0.6, 2.1}, {1.4, 2.1}}));
  EXPECT_FALSE(through(kScreen));
}

TEST(SeesThrough, TargetBesideSaysNothing) {
  EXPECT_FALSE(through({{6.0, 4.0}, {9.0, 4.0}}));
  EXPECT_FALSE(through({{-9.0, 4.0}, {-6.0, 4.0}}));
}

TEST(SeesThrough, NarrowGlimpseSaysNothing) { EXPECT_FALSE(through({{0.95, 4.0}, {1.05, 4.0}})); }

TEST(SeesThrough, LaserInTheLineOfTheWallSeesNothing) {
  EXPECT_FALSE(through({{-1.0, 3.0}, {3.0, 3.0}}, kScreen, {-1.0, 2.0}));
}

TEST(SeesThrough, TargetAlongOneRayHasNoWidth) { EXPECT_FALSE(through({{1.0, 1.0}, {1.0, 5.0}})); }

TEST(SeesThrough, TargetThatCrossesTheLineCountsWhereItIsBehind) {
  const auto slanted = through({{-1.0, 1.0}, {3.0, 5.0}});
  ASSERT_TRUE(slanted);
  EXPECT_GT(slanted->from, 0.0);
}

TEST(WidestOpening, JoinsPiecesThatTouch) {
  Wall left;
  left.segment = {{0.4, 4.0}, {1.0, 4.0}};
  Wall right;
  right.segment = {{1.0, 4.0}, {1.6, 4.0}};
  Wall apart;
  apart.segment = {{2.2, 4.0}, {2.6, 4.0}};
  const auto piece = widest_opening(kScreen, kLaser, {apart, right, left}, {});
  ASSERT_TRUE(piece);
  EXPECT_NEAR(piece->from, 0.7, 1e-12);
  EXPECT_NEAR(piece->to, 1.3, 1e-12);
  EXPECT_FALSE(widest_opening(kScreen, kLaser, {}, {}));
}

}  // namespace
}  // namespace perceptor::merge
