#include "common/geometry/segment.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/unit/common/geometry/random_scene.hpp"

namespace perceptor {
namespace {

constexpr double pi = std::numbers::pi;

/// Some operations on numbers up to 20, each good to 16 digits.
constexpr double kRounding = 1e-13;

Segment segment(double ax, double ay, double bx, double by) {
  return {Vector2(ax, ay), Vector2(bx, by)};
}

Segment reversed(const Segment& s) { return {s.b, s.a}; }

const Segment kPoint = segment(1.0, 2.0, 1.0, 2.0);
const Segment kAlongX = segment(0.0, 0.0, 4.0, 0.0);

TEST(Segment, LengthMiddleDirectionAndAngle) {
  const Segment s = segment(1.0, 1.0, 4.0, 5.0);
  EXPECT_EQ(length(s), 5.0);
  EXPECT_EQ(middle(s), Vector2(2.5, 3.0));
  EXPECT_NEAR(distance(direction(s), Vector2(0.6, 0.8)), 0.0, 1e-15);
  EXPECT_NEAR(angle(s), std::atan2(4.0, 3.0), 1e-15);
}

TEST(Segment, OneWithoutLengthHasNoDirection) {
  EXPECT_EQ(length(kPoint), 0.0);
  EXPECT_EQ(angle(kPoint), 0.0);
  EXPECT_EQ(direction(kPoint), Vector2::Zero());
  EXPECT_EQ(middle(kPoint), kPoint.a);
}

TEST(Segment, WallsAtPlusAndMinusPiHaveOneAngle) {
  EXPECT_EQ(angle(segment(4.0, 0.0, 0.0, 0.0)), pi);
  EXPECT_EQ(angle(segment(4.0, 0.0, 0.0, -0.0)), pi);
  const Segment just_above = segment(4.0, 0.0, 0.0, 1e-9);
  const Segment just_below = segment(4.0, 0.0, 0.0, -1e-9);
  EXPECT_NEAR(smallest_relative_angle(just_above, just_below), 0.0, 1e-9);
  EXPECT_NEAR(angle_between(just_above, just_below), 0.0, 1e-9);
}

TEST(SmallestRelativeAngle, IsThatOfTheLinesWhicheverWayTheyRun) {
  EXPECT_EQ(smallest_relative_angle(kAlongX, reversed(kAlongX)), 0.0);
  EXPECT_EQ(smallest_relative_angle(kAlongX, segment(1.0, 1.0, 1.0, 5.0)), 0.5 * pi);
  RandomScene scene;
  for (int i = 0; i < kTries; ++i) {
    const Segment s = scene.segment();
    const Segment t = scene.segment();
    const double between = smallest_relative_angle(s, t);
    EXPECT_GE(between, 0.0);
    EXPECT_LE(between, 0.5 * pi);
    EXPECT_NEAR(smallest_relative_angle(t, s), between, kRounding);
    EXPECT_NEAR(smallest_relative_angle(reversed(s), t), between, kRounding);
    const double turn = std::fmod(angle_between(s, t), pi);
    EXPECT_NEAR(std::min(turn, pi - turn), between, kRounding);
  }
}

TEST(SmallestRelativeAngle, IsZeroForOneWithoutLength) {
  EXPECT_EQ(smallest_relative_angle(kPoint, segment(0.0, 0.0, 0.0, 1.0)), 0.0);
  EXPECT_EQ(smallest_relative_angle(kPoint, kPoint), 0.0);
}

TEST(AngleBetween, RunsCounterClockwiseFromTheFirst) {
  const Segment up = segment(0.0, 0.0, 0.0, 1.0);
  EXPECT_NEAR(angle_between(kAlongX, up), 0.5 * pi, 1e-15);
  EXPECT_NEAR(angle_between(up, kAlongX), 1.5 * pi, 1e-15);
  EXPECT_EQ(angle_between(kAlongX, reversed(kAlongX)), pi);
  EXPECT_EQ(angle_between(reversed(kAlongX), kAlongX), pi);
}

TEST(AngleBetween, StaysBelowAFullTurn) {
  EXPECT_EQ(angle_between(kAlongX, kAlongX), 0.0);
  // So little clockwise that a full turn less that is a full turn again.
  EXPECT_EQ(angle_between(kAlongX, segment(0.0, 0.0, 4.0, -1e-20)), 0.0);
  RandomScene scene;
  for (int i = 0; i < kTries; ++i) {
    const Segment s = scene.segment();
    const Segment t = scene.segment();
    const double turn = angle_between(s, t);
    EXPECT_GE(turn, 0.0);
    EXPECT_LT(turn, 2.0 * pi);
    EXPECT_NEAR(turn + angle_between(t, s), 2.0 * pi, kRounding);
  }
}

TEST(AngleBetween, IsZeroForOneWithoutLength) {
  EXPECT_EQ(angle_between(kPoint, segment(0.0, 0.0, 0.0, 1.0)), 0.0);
  EXPECT_EQ(angle_between(segment(0.0, 0.0, 0.0, 1.0), kPoint), 0.0);
}

TEST(SignedDistance, IsPositiveOnTheLeft) {
  EXPECT_EQ(signed_distance(kAlongX, Vector2(100.0, 3.0)), 3.0);
  EXPECT_EQ(signed_distance(kAlongX, Vector2(-100.0, -3.0)), -3.0);
  EXPECT_EQ(signed_distance(reversed(kAlongX), Vector2(100.0, 3.0)), -3.0);
  EXPECT_EQ(signed_distance(kAlongX, Vector2(7.0, 0.0)), 0.0);
}

TEST(SignedDistance, IsThatFromThePointWhereTheSegmentHasNoLength) {
  EXPECT_EQ(signed_distance(kPoint, Vector2(4.0, 6.0)), 5.0);
  EXPECT_EQ(signed_distance(kPoint, Vector2(-2.0, -2.0)), 5.0);
}

TEST(AveragePerpendicularDistance, IsTheMeanOfTheSecondsEndsFromTheFirstsLine) {
  EXPECT_EQ(average_perpendicular_distance(kAlongX, segment(9.0, 1.0, 20.0, 3.0)), 2.0);
  const Segment crossing = segment(0.0, -1.0, 4.0, 1.0);
  EXPECT_EQ(average_perpendicular_distance(kAlongX, crossing), 1.0) << "sides do not cancel";
  EXPECT_EQ(average_perpendicular_distance(kAlongX, segment(6.0, 0.0, 9.0, 0.0)), 0.0);
}

TEST(AveragePerpendicularDistance, IsOneSided) {
  const Segment short_steep = segment(0.0, 1.0, 0.0, 2.0);
  EXPECT_EQ(average_perpendicular_distance(kAlongX, short_steep), 1.5);
  EXPECT_EQ(average_perpendicular_distance(short_steep, kAlongX), 2.0);
}

TEST(MutualPerpendicularDistance, IsThatOfTheLongerLineInEitherOrder) {
  const Segment short_steep = segment(0.0, 1.0, 0.0, 2.0);
  EXPECT_EQ(mutual_perpendicular_distance(kAlongX, short_steep), 1.5);
  EXPECT_EQ(mutual_perpendicular_distance(short_steep, kAlongX), 1.5);
  RandomScene scene;
  for (int i = 0; i < kTries; ++i) {
    const Segment s = scene.segment();
    const Segment t = scene.segment();
    EXPECT_EQ(mutual_perpendicular_distance(s, t), mutual_perpendicular_distance(t, s));
  }
}

TEST(MutualPerpendicularDistance, TakesTheLargerOfTwoEquallyLong) {
  const Segment up = segment(0.0, 0.0, 0.0, 4.0);
  const Segment beside = segment(1.0, 0.0, 5.0, 0.0);
  EXPECT_EQ(mutual_perpendicular_distance(up, beside), 3.0);
  EXPECT_EQ(mutual_perpendicular_distance(beside, up), 3.0);
}

TEST(GapDistance, IsBetweenTheNearerEndsAlongTheLonger) {
  EXPECT_EQ(gap_distance(kAlongX, segment(6.0, 1.0, 7.0, 1.0)), 2.0) << "behind the end";
  EXPECT_EQ(gap_distance(kAlongX, segment(-3.0, 1.0, -5.0, 1.0)), 3.0) << "before the beginning";
  EXPECT_EQ(gap_distance(segment(6.0, 1.0, 7.0, 1.0), kAlongX), 2.0) << "the other order";
}

TEST(GapDistance, IsZeroWhereTheyTouchOverlapOrOneLiesWithinTheOther) {
  EXPECT_EQ(gap_distance(kAlongX, segment(4.0, 0.0, 6.0, 0.0)), 0.0) << "touching";
  EXPECT_EQ(gap_distance(kAlongX, segment(3.0, 1.0, 6.0, 1.0)), 0.0) << "overlapping";
  EXPECT_EQ(gap_distance(kAlongX, segment(1.0, 0.0, 2.0, 0.0)), 0.0) << "nested";
  EXPECT_EQ(gap_distance(kAlongX, kAlongX), 0.0) << "the same";
}

TEST(GapDistance, OfOneWithoutLengthIsMeasuredAlongTheOther) {
  EXPECT_EQ(gap_distance(kAlongX, segment(7.0, 5.0, 7.0, 5.0)), 3.0);
  EXPECT_EQ(gap_distance(segment(7.0, 5.0, 7.0, 5.0), kAlongX), 3.0);
}

TEST(GapDistance, OfTwoPointsIsTheirDistance) {
  EXPECT_EQ(gap_distance(kPoint, segment(4.0, 6.0, 4.0, 6.0)), 5.0);
  EXPECT_EQ(gap_distance(kPoint, kPoint), 0.0);
}

TEST(GapDistance, DoesNotDependOnTheOrderNorOnTheDirections) {
  RandomScene scene;
  for (int i = 0; i < kTries; ++i) {
    const Segment s = scene.segment();
    const Segment t = scene.segment();
    const double gap = gap_distance(s, t);
    EXPECT_EQ(gap_distance(t, s), gap);
    EXPECT_NEAR(gap_distance(reversed(s), t), gap, kRounding);
    EXPECT_NEAR(gap_distance(s, reversed(t)), gap, kRounding);
  }
}

TEST(ProjectedInterval, CountsMetresFromTheFirstEnd) {
  const auto [first, last] = projected_interval(kAlongX, segment(6.0, 1.0, -2.0, 7.0));
  EXPECT_EQ(first, -2.0);
  EXPECT_EQ(last, 6.0);
  const auto [none_first, none_last] = projected_interval(kPoint, kAlongX);
  EXPECT_EQ(none_first, 0.0);
  EXPECT_EQ(none_last, 0.0);
}

TEST(DistanceToASegment, CountsItsEnds) {
  EXPECT_EQ(distance(kAlongX, Vector2(2.0, 3.0)), 3.0);
  EXPECT_EQ(distance(kAlongX, Vector2(7.0, 4.0)), 5.0);
  EXPECT_EQ(distance(kAlongX, Vector2(-3.0, -4.0)), 5.0);
  EXPECT_EQ(distance(kAlongX, Vector2(1.0, 0.0)), 0.0);
  EXPECT_EQ(distance(kPoint, Vector2(4.0, 6.0)), 5.0);
}

TEST(Segment, WhatIsSaidOfTwoDoesNotDependOnTheFrame) {
  RandomScene scene;
  for (int i = 0; i < kTries; ++i) {
    const Segment s = scene.segment();
    const Segment t = scene.segment();
    const Position b_in_a = scene.position();
    const Segment s_in_a = transform(b_in_a, s);
    const Segment t_in_a = transform(b_in_a, t);
    EXPECT_NEAR(length(s_in_a), length(s), kRounding);
    EXPECT_NEAR(smallest_relative_angle(s_in_a, t_in_a), smallest_relative_angle(s, t), 1e-11);
    EXPECT_NEAR(gap_distance(s_in_a, t_in_a), gap_distance(s, t), 1e-11);
    EXPECT_NEAR(average_perpendicular_distance(s_in_a, t_in_a),
                average_perpendicular_distance(s, t), 1e-11);
  }
}

TEST(Segment, DistanceBetweenTwo) {
  const Segment s{{0.0, 0.0}, {2.0, 0.0}};
  EXPECT_EQ(distance(s, Segment{{1.0, -1.0}, {1.0, 1.0}}), 0.0) << "they cross";
  EXPECT_DOUBLE_EQ(distance(s, Segment{{1.0, 0.5}, {1.0, 2.0}}), 0.5);
  EXPECT_DOUBLE_EQ(distance(s, Segment{{5.0, 4.0}, {9.0, 4.0}}), 5.0) << "end to end";
  EXPECT_DOUBLE_EQ(distance(s, Segment{{3.0, 0.0}, {4.0, 0.0}}), 1.0) << "in one line";
}

}  // namespace
}  // namespace perceptor
