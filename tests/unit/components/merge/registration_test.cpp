#include "components/merge/registration.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/unit/components/merge/scene.hpp"

namespace perceptor::merge {
namespace {

double degrees(double value) { return value * std::numbers::pi / 180.0; }

TEST(Registration, StepOfOdometryIsCorrectedByARoom) {
  Session session;
  session.see_often(room(), 5, {2.0, 1.5, 0.0});
  // The robot drove 0.10 m; odometry says 0.14 m and a degree and a half of turn.
  const Map scan = transform(draw(room()), inverse(Position{2.1, 1.5, 0.0}));
  const LocalMap local = session.take(scan, {2.14, 1.51, degrees(1.5)});
  EXPECT_EQ(local.registered, 4);
  EXPECT_FALSE(local.rejected);
  EXPECT_FALSE(local.unobservable_direction);
  EXPECT_NEAR(local.robot_in_local.pose.x, 2.1, 0.003);
  EXPECT_NEAR(local.robot_in_local.pose.y, 1.5, 0.003);
  EXPECT_NEAR(local.robot_in_local.pose.a, 0.0, degrees(0.1));
  EXPECT_LT(std::sqrt(local.robot_in_local.covariance(0, 0)), 0.005);
}

TEST(Registration, CorridorLeavesOneDirectionToOdometry) {
  const std::vector<Drawn> corridor = {wall(-5, -1, 5, -1), wall(5, 1, -5, 1)};
  Session session;
  session.see_often(corridor, 5, {0.0, 0.0, 0.0});
  // Drove 0.2 m along it, odometry says 0.21 m, 2 cm sideways, and a degree of turn.
  const Position truth{0.2, 0.0, 0.5};
  const LocalMap local =
      session.take(transform(draw(corridor), inverse(truth)), {0.21, 0.02, 0.5 + degrees(1.0)});
  ASSERT_TRUE(local.unobservable_direction);
  // The corridor's axis, seen from a robot that is turned by 0.5 rad.
  EXPECT_NEAR(*local.unobservable_direction, -0.5, degrees(0.5));
  EXPECT_NEAR(local.robot_in_local.pose.y, 0.0, 0.003);
  EXPECT_NEAR(local.robot_in_local.pose.a, 0.5, degrees(0.1));
  EXPECT_NEAR(local.robot_in_local.pose.x, 0.21, 0.002);
  EXPECT_GT(local.robot_in_local.covariance(0, 0), 10.0 * local.robot_in_local.covariance(1, 1));
}

/// A corridor of which one wall was seen to end, by a robot that drove 0.2 m along it where
/// odometry says 0.25 m.
LocalMap after_a_slip(Landmarks landmarks) {
  const std::vector<Drawn> corridor = {wall(-5, -1, 3, -1, CornerMethod::none, CornerMethod::spike),
                                       wall(5, 1, -5, 1)};
  MergeParameters parameters;
  parameters.registration.landmarks = landmarks;
  Session session(parameters);
  session.see_often(corridor, 20, {0.0, 0.0, 0.0});
  return session.take(transform(draw(corridor), inverse(Position{0.2, 0.0, 0.0})),
                      {0.25, 0.0, 0.0});
}

TEST(Registration, EndOfAWallFixesWhereTheRobotIsAlongIt) {
  const LocalMap by_lines = after_a_slip(Landmarks::walls);
  EXPECT_TRUE(by_lines.unobservable_direction);
  EXPECT_NEAR(by_lines.robot_in_local.pose.x, 0.25, 0.002);
  const LocalMap by_both = after_a_slip(Landmarks::both);
  EXPECT_FALSE(by_both.unobservable_direction);
  EXPECT_NEAR(by_both.robot_in_local.pose.x, 0.2, 0.02);
}

TEST(Registration, CornersAloneTellHowTheRobotMoved) {
  std::vector<Drawn> corners = room();
  for (Drawn& drawn : corners) drawn.tail = drawn.head = CornerMethod::intersection;
  MergeParameters parameters;
  parameters.registration.landmarks = Landmarks::corners;
  Session session(parameters);
  session.see_often(corners, 5, {2.0, 1.5, 0.0});
  const Map scan = transform(draw(corners), inverse(Position{2.1, 1.5, 0.0}));
  const LocalMap local = session.take(scan, {2.14, 1.51, degrees(1.5)});
  EXPECT_FALSE(local.unobservable_direction);
  EXPECT_NEAR(local.robot_in_local.pose.x, 2.1, 0.005);
  EXPECT_NEAR(local.robot_in_local.pose.y, 1.5, 0.005);
  EXPECT_NEAR(local.robot_in_local.pose.a, 0.0, degrees(0.2));
}

TEST(Registration, WithoutWallsOdometryRules) {
  Session session;
  session.see_often(room(), 5, {2.0, 1.5, 0.0});
  const LocalMap local = session.see({}, {2.3, 1.6, 0.2});
  EXPECT_EQ(local.registered, 0);
  EXPECT_FALSE(local.rejected);
  EXPECT_TRUE(local.unobservable_direction);
  EXPECT_NEAR(local.robot_in_local.pose.x, 2.3, 0.002);
  EXPECT_NEAR(local.robot_in_local.pose.y, 1.6, 0.002);
}

TEST(Registration, SomethingThatMovedDoesNotPullThePose) {
  std::vector<Drawn> scene = room();
  scene.push_back(wall(3, 2, 1, 2));
  Session session;
  session.see_often(scene, 10, {2.0, 1.0, 0.0});
  scene.back() = wall(3, 2.08, 1, 2.08);
  const LocalMap local = session.see(scene, {2.0, 1.0, 0.0});
  EXPECT_NEAR(local.robot_in_local.pose.y, 1.0, 0.002);
}

TEST(Registration, SlipFarBeyondTheNoiseIsCorrectedWhereAllWallsAgree) {
  Session session;
  session.see_often(room(), 5, {2.0, 1.5, 0.0});
  const Map scan = transform(draw(room()), inverse(Position{2.0, 1.5, 0.0}));
  const LocalMap local = session.take(scan, {2.09, 1.45, 0.0});
  EXPECT_FALSE(local.rejected);
  EXPECT_NEAR(local.robot_in_local.pose.x, 2.0, 0.005);
  EXPECT_NEAR(local.robot_in_local.pose.y, 1.5, 0.005);
}

TEST(Registration, ImplausibleCorrectionIsRejected) {
  MergeParameters parameters;
  parameters.registration.max_correction = 0.02;
  Session session(parameters);
  session.see_often(room(), 5, {2.0, 1.5, 0.0});
  const Map scan = transform(draw(room()), inverse(Position{2.0, 1.5, 0.0}));
  const LocalMap local = session.take(scan, {2.09, 1.5, 0.0});
  EXPECT_TRUE(local.rejected);
  EXPECT_EQ(local.registered, 0);
  EXPECT_NEAR(local.robot_in_local.pose.x, 2.09, 1e-9);
  EXPECT_EQ(session.walls().size(), 4U);
}

TEST(Registration, AfterManyRejectedScansOdometryIsBelieved) {
  MergeParameters parameters;
  parameters.registration.max_correction = 0.02;
  parameters.max_rejected_scans = 3;
  Session session(parameters);
  session.see_often(room(), 5, {2.0, 1.5, 0.0});
  const Map moved = transform(draw(room()), inverse(Position{2.0, 1.5, 0.0}));
  for (int i = 0; i < 3; ++i) session.take(moved, {2.09, 1.5, 0.0});
  EXPECT_EQ(session.walls().front().sightings, 5);
  session.take(moved, {2.09, 1.5, 0.0});
  EXPECT_NE(session.walls().front().sightings, 5);
}

TEST(Registration, FewWallsThatAgreeAreNotBelieved) {
  MergeParameters parameters;
  parameters.registration.min_agreement = 0.9;
  Session session(parameters);
  session.see_often({wall(0, 0, 4, 0), wall(4, 3, 0, 3)}, 5, {2.0, 1.5, 0.0});
  // The two walls of the corridor moved 8 cm towards each other: one can fit, not both.
  const LocalMap local =
      session.see({wall(0, 0.16, 4, 0.16), wall(4, 2.84, 0, 2.84)}, {2.0, 1.5, 0.0});
  EXPECT_TRUE(local.rejected || local.registered == 0);
}

}  // namespace
}  // namespace perceptor::merge
