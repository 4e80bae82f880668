#include "components/viewer/frames.hpp"

#include <numbers>

#include <gtest/gtest.h>

namespace perceptor::viewer {
namespace {

constexpr double kExact = 1e-12;

void expect_near(const Position& found, const Position& expected) {
  EXPECT_NEAR(found.x, expected.x, kExact);
  EXPECT_NEAR(found.y, expected.y, kExact);
  EXPECT_NEAR(found.a, expected.a, kExact);
}

TEST(Frames, WithoutAPoseTheRobotStandsAtTheOrigin) {
  const Frames frames;
  EXPECT_EQ(frames.frame(), SceneFrame::robot);
  expect_near(frames.robot_in_scene(), {});
  EXPECT_TRUE(frames.world_in_scene()) << "a map alone is shown";
}

TEST(Frames, OdometryAloneMovesTheRobot) {
  Frames frames;
  frames.take_zero_pose(1, {1.0, 2.0, 0.5});
  EXPECT_EQ(frames.frame(), SceneFrame::local);
  expect_near(frames.robot_in_scene(), {1.0, 2.0, 0.5});
  EXPECT_FALSE(frames.world_in_scene());
}

TEST(Frames, LaterOdometryGoesOnFromWhereTheDriftWasTakenOut) {
  Frames frames;
  frames.take_local_pose(10, {1.0, 0.0, 0.0}, {1.1, 0.0, 0.0});
  frames.take_zero_pose(20, {2.0, 0.0, 0.0});
  expect_near(frames.robot_in_scene(), {2.1, 0.0, 0.0});
  expect_near(frames.robot_in_scene(10), {1.1, 0.0, 0.0});
  expect_near(frames.robot_in_scene(15), frames.robot_in_scene());
}

TEST(Frames, TheWorldIsTheSceneWhereTheRobotIsFoundInIt) {
  Frames frames;
  frames.take_local_pose(10, {1.0, 0.0, 0.0}, {1.0, 0.0, 0.0});
  frames.take_world_pose(10, Position{5.0, 5.0, std::numbers::pi / 2.0});
  EXPECT_EQ(frames.frame(), SceneFrame::world);
  expect_near(frames.robot_in_scene(), {5.0, 5.0, std::numbers::pi / 2.0});
  expect_near(frames.local_in_scene(), {5.0, 4.0, std::numbers::pi / 2.0});
  expect_near(frames.world_in_scene().value(), {});
}

TEST(Frames, ChannelsMayComeInAnyOrder) {
  Frames frames;
  frames.take_world_pose(10, Position{5.0, 5.0, 0.0});
  EXPECT_EQ(frames.frame(), SceneFrame::robot);
  frames.take_local_pose(10, {}, {1.0, 0.0, 0.0});
  EXPECT_EQ(frames.frame(), SceneFrame::world);
  expect_near(frames.robot_in_scene(), {5.0, 5.0, 0.0});
}

TEST(Frames, ALostPlaceIsTakenBack) {
  Frames frames;
  frames.take_local_pose(10, {}, {1.0, 0.0, 0.0});
  frames.take_world_pose(10, Position{5.0, 5.0, 0.0});
  frames.take_world_pose(20, std::nullopt);
  EXPECT_EQ(frames.frame(), SceneFrame::local);
  EXPECT_FALSE(frames.world_in_scene());
}

TEST(Frames, TheTrueWorldIsLaidOnTheFirstTruePose) {
  Frames frames;
  frames.take_local_pose(10, {}, {0.0, 0.0, 0.0});
  EXPECT_FALSE(frames.true_world_in_scene());
  frames.take_true_pose(10, {3.0, 1.0, 0.0});
  frames.take_local_pose(20, {}, {1.0, 0.0, 0.0});
  frames.take_true_pose(20, {4.5, 1.0, 0.0});
  expect_near(frames.true_world_in_scene().value(), {-3.0, -1.0, 0.0});
}

}  // namespace
}  // namespace perceptor::viewer
