#include "components/merge/same_wall.hpp"

#include <gtest/gtest.h>

namespace perceptor::merge {
namespace {

Wall make_wall(double ax, double ay, double bx, double by, double offset_sigma = 0.003,
               double angle_sigma = 0.003) {
  Wall wall;
  wall.segment = {{ax, ay}, {bx, by}};
  wall.covariance =
      Eigen::Vector2d(offset_sigma * offset_sigma, angle_sigma * angle_sigma).asDiagonal();
  return wall;
}

std::optional<Difference> difference(const Wall& p, const Wall& q) {
  const auto there = compare(p, line_of(p.segment), q, line_of(q.segment), {});
  const auto back = compare(q, line_of(q.segment), p, line_of(p.segment), {});
  EXPECT_EQ(there.has_value(), back.has_value());
  if (there && back) {
    EXPECT_NEAR(there->offset, back->offset, 1e-12);
    EXPECT_NEAR(there->gap, back->gap, 1e-12);
  }
  return there;
}

const Wall kLong = make_wall(0, 0, 4, 0);

TEST(SameWall, IsOneWithItself) {
  const auto same = difference(kLong, kLong);
  ASSERT_TRUE(same);
  EXPECT_DOUBLE_EQ(same->score, 0.0);
}

TEST(SameWall, NestedPieceIsPartOfIt) {
  const auto same = difference(kLong, make_wall(1, 0.01, 2, 0.01));
  ASSERT_TRUE(same);
  EXPECT_NEAR(same->offset, 0.01, 1e-12);
  EXPECT_EQ(same->gap, 0.0);
}

TEST(SameWall, TwoHalvesWithASmallGapAreOne) {
  const auto same = difference(make_wall(0, 0, 2, 0), make_wall(2.2, 0, 4, 0));
  ASSERT_TRUE(same);
  EXPECT_NEAR(same->gap, 0.2, 1e-12);
}

TEST(SameWall, PiecesOnBothSidesOfAPartitionAreTwo) {
  //  room  |part|  room      The left one is known to end in its room's corner, 0.2 m before the
  //  ------+    +------      wall of the next room begins in line with it.
  Wall left = make_wall(0, 0, 2, 0);
  left.ends[kHead].method = CornerMethod::intersection;
  left.ends[kHead].variance = 1e-6;
  EXPECT_FALSE(difference(left, make_wall(2.2, 0, 4, 0)));
  Wall right = make_wall(2.2, 0, 4, 0);
  right.ends[kTail] = left.ends[kHead];
  EXPECT_FALSE(difference(make_wall(0, 0, 2, 0), right));
  EXPECT_TRUE(difference(left, make_wall(1.9, 0, 4, 0))) << "it was wrong about that end";
}

TEST(SameWall, OverlapIsLikerThanGap) {
  const auto overlap = difference(kLong, make_wall(3, 0.04, 5, 0.04));
  const auto gap = difference(kLong, make_wall(4.2, 0, 5, 0));
  ASSERT_TRUE(overlap && gap);
  EXPECT_LT(overlap->score, gap->score);
}

TEST(SameWall, PiecesAcrossADoorwayAreTwo) {
  EXPECT_FALSE(difference(make_wall(0, 0, 2, 0), make_wall(2.8, 0, 4, 0)));
}

TEST(SameWall, ParallelWallsApartAreTwo) {
  EXPECT_FALSE(difference(kLong, make_wall(0, 0.12, 4, 0.12)));
  EXPECT_FALSE(difference(kLong, make_wall(0, 0.3, 4, 0.3)));
}

TEST(SameWall, OppositeFacesAreTwoHoweverClose) {
  EXPECT_FALSE(difference(kLong, make_wall(4, -0.05, 0, -0.05)));
  EXPECT_FALSE(difference(kLong, make_wall(4, 0, 0, 0)));
}

TEST(SameWall, WallsAtAnAngleAreTwo) {
  EXPECT_FALSE(difference(kLong, make_wall(2, 0, 2.9, 0.2)));
  EXPECT_FALSE(difference(kLong, make_wall(2, 0, 2, 1)));
}

TEST(SameWall, UncertainWallsMayDifferMoreUpToABound) {
  const auto uncertain = [](double y) { return make_wall(1, y, 2, y, 0.02, 0.02); };
  EXPECT_TRUE(difference(kLong, uncertain(0.1)));
  EXPECT_FALSE(difference(kLong, uncertain(0.14)));
  EXPECT_FALSE(difference(kLong, make_wall(1, 0.16, 2, 0.16, 1.0, 1.0)));
}

TEST(SameWall, DirectionsOnBothSidesOfPiAreParallel) {
  const Wall left = make_wall(4, 0, 0, 0.01);
  const Wall right = make_wall(4, 0, 0, -0.01);
  EXPECT_TRUE(difference(left, right));
}

TEST(GapBetween, IsThePieceThatIsMissingOnEitherSide) {
  const Line whole = line_of(kLong.segment);
  const auto ahead = gap_between(whole, line_of({{4.2, 0.0}, {5.0, 0.0}}));
  const auto behind = gap_between(line_of({{-1.0, 0.0}, {-0.2, 0.0}}), whole);
  ASSERT_TRUE(ahead && behind);
  EXPECT_NEAR(ahead->a.x(), 4.0, 1e-12);
  EXPECT_NEAR(ahead->b.x(), 4.2, 1e-12);
  EXPECT_NEAR(behind->a.x(), -0.2, 1e-12);
  EXPECT_NEAR(behind->b.x(), 0.0, 1e-12);
  EXPECT_FALSE(gap_between(whole, line_of({{3.0, 0.0}, {5.0, 0.0}})));
}

}  // namespace
}  // namespace perceptor::merge
