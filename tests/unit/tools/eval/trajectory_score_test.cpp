#include "tools/eval/trajectory_score.hpp"

#include <gtest/gtest.h>

namespace perceptor {
namespace {

constexpr std::int64_t kSecond = 1'000'000;

/// One metre a second, straight ahead, a pose a second from 0 to 30 s.
Trajectory straight_drive() {
  Trajectory trajectory;
  for (int i = 0; i <= 30; ++i)
    trajectory.push_back({i * kSecond, {static_cast<double>(i), 0.0, 0.0}});
  return trajectory;
}

Trajectory seen_from_elsewhere(const Trajectory& trajectory) {
  Trajectory seen;
  for (const auto& [utime, pose] : trajectory)
    seen.push_back({utime, compose({5.0, -3.0, 2.0}, pose)});
  return seen;
}

TEST(DriftScore, APerfectTrajectoryInAnotherFrameHasNone) {
  const DriftScore score = score_drift(seen_from_elsewhere(straight_drive()), straight_drive());
  // Of 31 poses, 21 to 11 pairs at each of the distances from 10 to 20 m.
  EXPECT_EQ(score.pairs, 176);
  EXPECT_EQ(score.poses, 31);
  EXPECT_EQ(score.skipped, 0);
  EXPECT_NEAR(score.translation, 0.0, 1e-12);
  EXPECT_NEAR(score.heading, 0.0, 1e-12);
}

TEST(DriftScore, AScaleErrorGrowsWithTheWay) {
  Trajectory slow = straight_drive();
  for (TimedPose& timed : slow) timed.pose.x *= 0.9;
  const DriftScore score = score_drift(slow, straight_drive());
  EXPECT_NEAR(score.translation_per_metre, 0.1, 1e-12);
  EXPECT_GT(score.translation, 1.0);
  EXPECT_LT(score.translation, 2.0);
  EXPECT_NEAR(score.heading, 0.0, 1e-12);
}

TEST(DriftScore, AHeadingErrorCountsWhicheverWayItGoes) {
  // Turns left in one half of the way, back in the other: 0.01 rad/m.
  Trajectory weaving = straight_drive();
  for (TimedPose& timed : weaving)
    timed.pose.a = 0.01 * (timed.pose.x < 15.0 ? timed.pose.x : 30.0 - timed.pose.x);
  const DriftScore score =
      score_drift(weaving, straight_drive(), {.min_path = 14.5, .max_path = 15.5, .max_gap = 5.0});
  EXPECT_EQ(score.pairs, 16);
  // 15 m on, |15 - 2 i| cm: 0.15, 0.13, ..., 0.01, 0.01, ..., 0.15 rad.
  EXPECT_NEAR(score.heading, 0.08, 1e-12);
  EXPECT_NEAR(score.heading_per_metre, 0.08 / 15.0, 1e-12);
}

TEST(DriftScore, SkipsTheReferenceWhereTheTrajectorySaysNothing) {
  Trajectory shorter = straight_drive();
  shorter.erase(shorter.begin(), shorter.begin() + 5);
  const DriftScore score = score_drift(shorter, straight_drive());
  EXPECT_EQ(score.skipped, 5);
  EXPECT_EQ(score.pairs, 121);
}

TEST(DriftScore, WithoutPairsIsZero) {
  const DriftScore score = score_drift(straight_drive(), {{0, {0.0, 0.0, 0.0}}});
  EXPECT_EQ(score.pairs, 0);
  EXPECT_EQ(score.translation, 0.0);
}

TEST(DriftScore, PosesAreInterpolatedAtTheTimesOfTheReference) {
  Trajectory sparse;
  for (const TimedPose& timed : straight_drive())
    if (timed.utime % (3 * kSecond) == 0) sparse.push_back(timed);
  const DriftScore score = score_drift(sparse, straight_drive());
  EXPECT_EQ(score.skipped, 0);
  EXPECT_NEAR(score.translation, 0.0, 1e-12);
}

TEST(RelationScore, MeanAndSpreadOfTheAbsoluteErrors) {
  const std::vector<Relation> relations = {
      {0, 10 * kSecond, {10.3, 0.4, 0.1}},               // 0.5 m
      {10 * kSecond, 20 * kSecond, {10.0, -0.1, -0.3}},  // 0.1 m
      {20 * kSecond, 31 * kSecond, {11.0, 0.0, 0.0}},    // beyond the end
  };
  const RelationScore score = score_relations(seen_from_elsewhere(straight_drive()), relations);
  EXPECT_EQ(score.relations, 3);
  EXPECT_EQ(score.skipped, 1);
  EXPECT_NEAR(score.translation.mean, 0.3, 1e-12);
  EXPECT_NEAR(score.translation.sigma, 0.2, 1e-12);
  EXPECT_NEAR(score.rotation.mean, 0.2, 1e-12);
  EXPECT_NEAR(score.rotation.sigma, 0.1, 1e-12);
}

TEST(RelationScore, MayGoBackInTime) {
  const RelationScore score =
      score_relations(straight_drive(), {{10 * kSecond, 0, {-10.0, 0.0, 0.0}}});
  EXPECT_EQ(score.skipped, 0);
  EXPECT_NEAR(score.translation.mean, 0.0, 1e-12);
}

}  // namespace
}  // namespace perceptor
