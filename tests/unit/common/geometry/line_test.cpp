#include "common/geometry/line.hpp"

#include <numbers>

#include <gtest/gtest.h>

namespace perceptor {
namespace {

const Line kLine = line_of({{1.0, 1.0}, {5.0, 1.0}});

TEST(Line, AxesOfASegment) {
  EXPECT_EQ(kLine.middle, Vector2(3.0, 1.0));
  EXPECT_EQ(kLine.along, Vector2(1.0, 0.0));
  EXPECT_EQ(kLine.normal, Vector2(0.0, 1.0));
  EXPECT_DOUBLE_EQ(kLine.length, 4.0);
}

TEST(Line, OfASegmentWithoutLengthHasNoDirection) {
  const Line line = line_of({{1.0, 1.0}, {1.0, 1.0}});
  EXPECT_EQ(line.along, Vector2(0.0, 0.0));
  EXPECT_EQ(line.length, 0.0);
}

TEST(Line, TurnsTheShortWay) {
  const Line up = line_of({{0.0, 0.0}, {0.0, 2.0}});
  const Line back = line_of({{2.0, 0.0}, {0.0, 0.0}});
  EXPECT_DOUBLE_EQ(turn_between(kLine, up), std::numbers::pi / 2.0);
  EXPECT_DOUBLE_EQ(turn_between(up, kLine), -std::numbers::pi / 2.0);
  EXPECT_DOUBLE_EQ(turn_between(kLine, back), std::numbers::pi);
}

TEST(Line, PlacesCountFromTheMiddle) {
  EXPECT_DOUBLE_EQ(place_on(kLine, {4.0, 7.0}), 1.0);
  EXPECT_EQ(point_at(kLine, -2.0), Vector2(1.0, 1.0));
  EXPECT_EQ(extent_of(kLine), (Interval{-2.0, 2.0}));
}

TEST(Line, ExtentOfAnotherDoesNotDependOnItsWay) {
  const Interval there = extent_on(kLine, line_of({{4.0, 2.0}, {8.0, 5.0}}));
  const Interval back = extent_on(kLine, line_of({{8.0, 5.0}, {4.0, 2.0}}));
  EXPECT_NEAR(there.from, 1.0, 1e-12);
  EXPECT_NEAR(there.to, 5.0, 1e-12);
  EXPECT_NEAR(back.from, there.from, 1e-12);
  EXPECT_NEAR(back.to, there.to, 1e-12);
}

TEST(Interval, CommonPartOfWhatLiesApartIsNothing) {
  EXPECT_DOUBLE_EQ(common_part({0.0, 2.0}, {1.0, 5.0}).length(), 1.0);
  EXPECT_LT(common_part({0.0, 2.0}, {3.0, 5.0}).length(), 0.0);
  EXPECT_TRUE((Interval{0.0, 2.0}).contains(2.0));
  EXPECT_FALSE((Interval{0.0, 2.0}).contains(2.1));
  EXPECT_DOUBLE_EQ((Interval{1.0, 2.0}).middle(), 1.5);
}

}  // namespace
}  // namespace perceptor
