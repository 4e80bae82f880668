#include "tools/eval/true_association.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/scene.hpp"

namespace perceptor {
namespace {

constexpr double kRounding = 1e-9;

/// 5 beams from -0.2 to 0.2 rad on a wall in front, 5 from 0.3 to 0.7 on one to the left of it.
LabelledScan corner_scan(const Vector2& corner, const Vector2& right, const Vector2& left,
                         double corner_bearing) {
  test::SceneLaser laser;
  laser.bearings = {-0.2, -0.1, 0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7};
  LabelledScan scan;
  scan.scan = test::sweep(test::chain({right, corner, left}), laser);
  std::size_t first_left = 0;
  while (scan.scan.bearings[first_left] < corner_bearing) ++first_left;
  const auto end = [&](std::size_t beam) -> Vector2 {
    const double bearing = scan.scan.bearings[beam];
    return scan.scan.ranges[beam] * Vector2(std::cos(bearing), std::sin(bearing));
  };
  const std::size_t last = scan.scan.size() - 1;
  // The later one first: the order of the truth's lines does not matter.
  scan.pieces = {{2, first_left, last, last - first_left + 1, true, {end(first_left), end(last)}},
                 {1, 0, first_left - 1, first_left, true, {end(0), end(first_left - 1)}}};
  return scan;
}

LabelledScan room_corner() { return corner_scan({2.0, 0.5}, {2.0, -1.0}, {0.5, 0.6}, 0.245); }

TEST(TrueAssociation, FindsNoiselessWallsExactly) {
  const LabelledScan scan = room_corner();
  const FoundWalls found = walls_by_truth(scan);
  ASSERT_EQ(found.walls.size(), 2U);
  EXPECT_NEAR(distance(found.walls[0].a, scan.pieces[1].segment.a), 0.0, kRounding);
  EXPECT_NEAR(distance(found.walls[0].b, scan.pieces[1].segment.b), 0.0, kRounding);
  EXPECT_NEAR(distance(found.walls[1].a, scan.pieces[0].segment.a), 0.0, kRounding);
  EXPECT_NEAR(distance(found.walls[1].b, scan.pieces[0].segment.b), 0.0, kRounding);
}

TEST(TrueAssociation, ConcaveIsTheCornerOfARoom) {
  const FoundWalls found = walls_by_truth(room_corner(), {.min_turn = 0.2, .max_reach = 1.0});
  ASSERT_EQ(found.corners.size(), 1U);
  EXPECT_NEAR(distance(found.corners[0].location, Vector2(2.0, 0.5)), 0.0, kRounding);
  EXPECT_FALSE(found.corners[0].is_convex);
}

TEST(TrueAssociation, ConvexIsTheCornerThatSticksOut) {
  const FoundWalls found =
      walls_by_truth(corner_scan({2.0, 0.5}, {3.0, -1.5}, {3.0, 3.5}, 0.245), {.max_reach = 1.0});
  ASSERT_EQ(found.corners.size(), 1U);
  EXPECT_NEAR(distance(found.corners[0].location, Vector2(2.0, 0.5)), 0.0, kRounding);
  EXPECT_TRUE(found.corners[0].is_convex);
}

TEST(TrueAssociation, NoCornerBeyondReachOrWhereLinesHardlyTurn) {
  EXPECT_TRUE(walls_by_truth(room_corner(), {.max_reach = 0.01}).corners.empty());
  EXPECT_TRUE(walls_by_truth(room_corner(), {.min_turn = 1.56, .max_reach = 1.0}).corners.empty());
}

TEST(TrueAssociation, BeamsWithoutReturnAreLeftOut) {
  LabelledScan scan = room_corner();
  scan.scan.ranges[1] = 0.0;
  scan.scan.ranges[2] = 100.0;
  const FoundWalls found = walls_by_truth(scan);
  ASSERT_EQ(found.walls.size(), 2U);
  EXPECT_NEAR(signed_distance(found.walls[0], Vector2(2.0, 0.0)), 0.0, kRounding);
}

TEST(TrueAssociation, NoWallWhereOneBeamOrNoneReturned) {
  LabelledScan scan = room_corner();
  for (std::size_t i = scan.pieces[1].first_beam; i < scan.pieces[1].last_beam; ++i)
    scan.scan.ranges[i] = 0.0;
  EXPECT_EQ(walls_by_truth(scan).walls.size(), 1U);
  for (double& range : scan.scan.ranges) range = 0.0;
  EXPECT_TRUE(walls_by_truth(scan).walls.empty());
}

TEST(TrueAssociation, OutliersTellNothingOfTheirWall) {
  LabelledScan scan = room_corner();
  scan.scan.range_sigma = 0.01;
  const Segment without = walls_by_truth(scan).walls.at(0);
  scan.scan.ranges[1] += 0.5;
  const Segment with = walls_by_truth(scan).walls.at(0);
  EXPECT_NEAR(distance(with.a, without.a), 0.0, kRounding);
  EXPECT_NEAR(distance(with.b, without.b), 0.0, kRounding);
}

TEST(TrueAssociation, LeavesOutWhatNeedNotBeFound) {
  LabelledScan scan = room_corner();
  scan.pieces[0].has_to_be_found = false;
  EXPECT_EQ(walls_by_truth(scan).walls.size(), 1U);
}

TEST(TrueAssociation, OnNoiseItIsTheMostLikelyLine) {
  LabelledScan scan = room_corner();
  scan.scan.range_sigma = 0.015;
  const double noise[] = {0.01, -0.02, 0.015, -0.005};
  for (std::size_t i = 0; i < 4; ++i) scan.scan.ranges[i] += noise[i];
  const auto squares = [&](const Segment& wall) {
    double sum = 0.0;
    for (std::size_t i = scan.pieces[1].first_beam; i <= scan.pieces[1].last_beam; ++i) {
      const Vector2 ray(std::cos(scan.scan.bearings[i]), std::sin(scan.scan.bearings[i]));
      const double range = cross(wall.a, wall.b - wall.a) / cross(ray, wall.b - wall.a);
      sum += std::pow(range - scan.scan.ranges[i], 2);
    }
    return sum;
  };
  const Segment best = walls_by_truth(scan).walls.at(0);
  for (const double step : {-1e-4, 1e-4}) {
    EXPECT_LT(squares(best), squares({best.a + Vector2(step, 0.0), best.b}));
    EXPECT_LT(squares(best), squares({best.a, best.b + Vector2(step, 0.0)}));
  }
}

}  // namespace
}  // namespace perceptor
