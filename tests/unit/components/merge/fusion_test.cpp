#include "components/merge/fusion.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace perceptor::merge {
namespace {

Wall make_wall(double ax, double ay, double bx, double by, double offset_sigma = 0.01,
               double angle_sigma = 0.01) {
  Wall wall;
  wall.segment = {{ax, ay}, {bx, by}};
  wall.covariance =
      Eigen::Vector2d(offset_sigma * offset_sigma, angle_sigma * angle_sigma).asDiagonal();
  for (WallEnd& end : wall.ends) {
    end.variance = 0.01 * 0.01;
    end.radius = 0.2;
  }
  return wall;
}

Wall known_head(Wall wall) {
  wall.ends[kHead].method = CornerMethod::spike;
  return wall;
}

TEST(Fusion, LineLiesBetweenTwoEquallyCertainOnes) {
  const Wall fused = fuse(make_wall(0, 0, 2, 0), make_wall(0, 0.01, 2, 0.01), {});
  EXPECT_NEAR(fused.segment.a.y(), 0.005, 1e-9);
  EXPECT_NEAR(fused.segment.b.y(), 0.005, 1e-9);
  EXPECT_NEAR(fused.covariance(0, 0), 0.01 * 0.01 / 2.0, 1e-12);
}

TEST(Fusion, CertainLineHardlyMoves) {
  const Wall fused = fuse(make_wall(0, 0, 2, 0, 0.001, 0.001), make_wall(0, 0.01, 2, 0.01), {});
  EXPECT_NEAR(fused.segment.a.y(), 1e-4, 2e-5);
}

TEST(Fusion, LongLineRulesTheAngleOfAShortOne) {
  const Wall line = make_wall(0, 0, 4, 0, 0.002, 0.001);
  const Wall fused = fuse(line, make_wall(1, 0, 1.2, 0.02, 0.005, 0.1), {});
  EXPECT_NEAR(angle(fused.segment), 0.0, 0.001);
  EXPECT_NEAR(length(fused.segment), 4.0, 0.001);
}

TEST(Fusion, OutlierMovesLessThanItsShare) {
  // Twenty standard deviations off: information alone would move it half the way.
  const Wall fused =
      fuse(make_wall(0, 0, 2, 0, 0.002, 0.002), make_wall(0, 0.05, 2, 0.05, 0.002, 0.002), {});
  EXPECT_LT(fused.segment.a.y(), 0.012);
}

TEST(Fusion, ExtentIsTheUnion) {
  const Wall fused = fuse(make_wall(0, 0, 2, 0), make_wall(1.5, 0, 4, 0), {});
  EXPECT_NEAR(fused.segment.a.x(), 0.0, 1e-9);
  EXPECT_NEAR(fused.segment.b.x(), 4.0, 1e-9);
}

TEST(Fusion, CovarianceBelongsToTheNewMiddle) {
  // Seen at its tail only: at the middle of the union the angle's error counts as well.
  const Wall fused =
      fuse(make_wall(0, 0, 1, 0, 0.001, 0.01), make_wall(0.2, 0, 5, 0, 1.0, 1.0), {});
  EXPECT_NEAR(std::sqrt(fused.covariance(0, 0)), 0.02, 0.001);
}

TEST(Fusion, KnownEndsAreAveraged) {
  const Wall fused =
      fuse(known_head(make_wall(0, 0, 2, 0)), known_head(make_wall(0, 0, 2.02, 0)), {});
  EXPECT_NEAR(fused.segment.b.x(), 2.01, 1e-9);
  EXPECT_LT(fused.ends[kHead].radius, 0.2);
}

TEST(Fusion, KnownEndReplacesAnUnknownOneNearby) {
  const Wall fused = fuse(make_wall(0, 0, 2.1, 0), known_head(make_wall(0, 0, 2, 0)), {});
  EXPECT_NEAR(fused.segment.b.x(), 2.0, 1e-9);
  EXPECT_EQ(fused.ends[kHead].method, CornerMethod::spike);
}

TEST(Fusion, EndSeenWellBeforeWhereTheLinesMeetStands) {
  Wall to_corner = make_wall(0, 0, 2.15, 0);
  to_corner.ends[kHead].method = CornerMethod::intersection;
  const Wall seen = known_head(make_wall(0, 0, 2, 0));
  EXPECT_NEAR(fuse(to_corner, seen, {}).segment.b.x(), 2.0, 1e-9);
  EXPECT_NEAR(fuse(seen, to_corner, {}).segment.b.x(), 2.0, 1e-9);
}

TEST(Fusion, EndSeenByFewBeamsDoesNotTakeACornerBack) {
  // Beams 0.1 m apart: the wall may go on for as much behind the last one.
  Wall to_corner = make_wall(0, 0, 2.15, 0);
  to_corner.ends[kHead].method = CornerMethod::intersection;
  Wall seen = known_head(make_wall(0, 0, 2, 0));
  seen.ends[kHead].variance = 0.1 * 0.1;
  EXPECT_NEAR(fuse(to_corner, seen, {}).segment.b.x(), 2.15, 0.005);
}

TEST(Fusion, PartialViewLeavesTheEnd) {
  const Wall fused = fuse(known_head(make_wall(0, 0, 2, 0)), known_head(make_wall(0, 0, 1, 0)), {});
  EXPECT_NEAR(fused.segment.b.x(), 2.0, 1e-9);
}

TEST(Fusion, KnownEndMovesOnlyAfterSeveralSightingsBeyond) {
  Wall wall = known_head(make_wall(0, 0, 2, 0));
  const Wall beyond = make_wall(0, 0, 3, 0);
  wall = fuse(wall, beyond, {});
  wall = fuse(wall, beyond, {});
  EXPECT_NEAR(wall.segment.b.x(), 2.0, 1e-9);
  wall = fuse(wall, beyond, {});
  EXPECT_NEAR(wall.segment.b.x(), 3.0, 1e-9);
}

TEST(Fusion, OneSightingBeyondIsForgottenWhenTheEndIsSeenAgain) {
  const Wall end = known_head(make_wall(0, 0, 2, 0));
  const Wall beyond = make_wall(0, 0, 3, 0);
  Wall wall = end;
  for (int i = 0; i < 5; ++i) {
    wall = fuse(wall, beyond, {});
    wall = fuse(wall, end, {});
  }
  EXPECT_NEAR(wall.segment.b.x(), 2.0, 1e-9);
}

TEST(Fusion, ThousandGoodSightingsSharpenTheLineUpToTheFloor) {
  Wall wall = make_wall(0, 0, 2, 0);
  for (int i = 0; i < 100; ++i) wall = fuse(wall, make_wall(0, 0, 2, 0), {});
  EXPECT_NEAR(std::sqrt(wall.covariance(0, 0)), 0.001, 1e-4);
  for (int i = 0; i < 10'000; ++i) wall = fuse(wall, make_wall(0, 0, 2, 0), {});
  EXPECT_NEAR(std::sqrt(wall.covariance(0, 0)), 2e-4, 1e-9);
}

TEST(Fusion, WeightAndSightingsCountScansNotPieces) {
  Wall wall = make_wall(0, 0, 2, 0);
  Wall next = make_wall(0, 0, 1, 0);
  next.last_seen = 10;
  next.support = 5;
  wall = fuse(wall, next, {});
  wall = fuse(wall, next, {});
  EXPECT_EQ(wall.sightings, 2);
  EXPECT_DOUBLE_EQ(wall.weight, 2.0);
  EXPECT_EQ(wall.support, 10);
}

}  // namespace
}  // namespace perceptor::merge
