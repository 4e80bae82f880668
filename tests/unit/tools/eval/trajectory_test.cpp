#include "tools/eval/trajectory.hpp"

#include <gmock/gmock.h>

namespace perceptor {
namespace {

constexpr double kAnyGap = 1e9;

const Trajectory kTrajectory = {
    {1'000'000, {0.0, 0.0, 3.0}}, {2'000'000, {2.0, 4.0, -3.0}}, {6'000'000, {2.0, 8.0, -3.0}}};

TEST(PoseAt, BetweenTwoPosesTheHeadingGoesTheShortWay) {
  const auto pose = pose_at(kTrajectory, 1'500'000, kAnyGap);
  ASSERT_TRUE(pose);
  EXPECT_NEAR(pose->x, 1.0, 1e-12);
  EXPECT_NEAR(pose->y, 2.0, 1e-12);
  EXPECT_NEAR(std::abs(pose->a), 3.14159265, 1e-6);
}

TEST(PoseAt, OneOfThemIsThatOne) {
  EXPECT_EQ(pose_at(kTrajectory, 1'000'000, 0.0), kTrajectory[0].pose);
  EXPECT_EQ(pose_at(kTrajectory, 6'000'000, 0.0), kTrajectory[2].pose);
}

TEST(PoseAt, OutsideThereIsNone) {
  EXPECT_FALSE(pose_at(kTrajectory, 999'999, kAnyGap));
  EXPECT_FALSE(pose_at(kTrajectory, 6'000'001, kAnyGap));
  EXPECT_FALSE(pose_at({}, 1'000'000, kAnyGap));
}

TEST(PoseAt, NorAcrossAGap) {
  EXPECT_TRUE(pose_at(kTrajectory, 3'000'000, 4.0));
  EXPECT_FALSE(pose_at(kTrajectory, 3'000'000, 3.9));
}

TEST(PutInOrder, OfOneTimeTheFirstStays) {
  Trajectory trajectory = {{3, {1.0}}, {1, {2.0}}, {3, {3.0}}, {2, {4.0}}};
  put_in_order(trajectory);
  ASSERT_EQ(trajectory.size(), 3U);
  EXPECT_EQ(trajectory[0].pose.x, 2.0);
  EXPECT_EQ(trajectory[1].pose.x, 4.0);
  EXPECT_EQ(trajectory[2].pose.x, 1.0);
}

TEST(Driven, FromPoseToPose) {
  EXPECT_THAT(driven({{0, {0.0, 0.0}}, {1, {3.0, 4.0}}, {2, {3.0, 4.0}}, {3, {3.0, 2.0}}}),
              ::testing::ElementsAre(0.0, 5.0, 5.0, 7.0));
  EXPECT_TRUE(driven({}).empty());
}

}  // namespace
}  // namespace perceptor
