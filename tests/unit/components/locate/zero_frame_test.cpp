#include "components/locate/zero_frame.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "common/geometry/angle.hpp"
#include "common/geometry/twist.hpp"

namespace perceptor {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kRounding = 1e-9;          // [m], [rad] of a few compositions
constexpr std::int64_t kStart = 1'000'000;  // [us]
constexpr std::int64_t kPeriod = 25'000;    // [us] odometry at 40 Hz
constexpr double kPeriodSeconds = 0.025;
constexpr Twist kDrive{.vx = 0.5, .vy = 0.0, .va = 1.2};  // as fast as PICO can
constexpr double kDrivenInPeriod = 0.5 * kPeriodSeconds;  // [m]
constexpr double kTurnedInPeriod = 1.2 * kPeriodSeconds;  // [rad]

/// The odometry of a drive at constant speed, from any first pose, once each period.
std::vector<Position> drive(const Position& start_in_odometry, int steps,
                            const Twist& twist = kDrive) {
  std::vector<Position> robot_in_odometry;
  for (int i = 0; i <= steps; ++i)
    robot_in_odometry.push_back(compose(start_in_odometry, move(twist, i * kPeriodSeconds)));
  return robot_in_odometry;
}

/// The same drive by odometry that began elsewhere, from step `first` on.
void shift_from(std::vector<Position>& robot_in_odometry, std::size_t first,
                const Position& old_in_new_odometry) {
  for (std::size_t i = first; i < robot_in_odometry.size(); ++i)
    robot_in_odometry[i] = compose(old_in_new_odometry, robot_in_odometry[i]);
}

std::vector<ZeroPosition> follow(const std::vector<Position>& robot_in_odometry,
                                 std::int64_t period = kPeriod) {
  ZeroFrame zero_frame;
  std::vector<ZeroPosition> positions;
  std::int64_t utime = kStart;
  for (const Position& pose : robot_in_odometry) {
    positions.push_back(zero_frame.update(utime, pose, positions.empty()));
    utime += period;
  }
  return positions;
}

void expect_near(const Position& actual, const Position& expected, double tolerance = kRounding) {
  EXPECT_NEAR(actual.x, expected.x, tolerance);
  EXPECT_NEAR(actual.y, expected.y, tolerance);
  EXPECT_NEAR(angle_difference(expected.a, actual.a), 0.0, tolerance);
}

/// No step of the position is longer than the robot can drive in one period.
void expect_continuous(const std::vector<ZeroPosition>& positions) {
  for (std::size_t i = 1; i < positions.size(); ++i) {
    const Position& before = positions[i - 1].robot_in_zero;
    const Position& after = positions[i].robot_in_zero;
    EXPECT_LE(distance(before.location(), after.location()), kDrivenInPeriod + kRounding);
    EXPECT_LE(std::abs(angle_difference(before.a, after.a)), kTurnedInPeriod + kRounding);
  }
}

/// Whether each odometry is where the message says: zero composed with the robot in zero.
void expect_consistent(const std::vector<ZeroPosition>& positions,
                       const std::vector<Position>& robot_in_odometry) {
  ASSERT_EQ(positions.size(), robot_in_odometry.size());
  for (std::size_t i = 0; i < positions.size(); ++i)
    expect_near(compose(positions[i].zero_in_odometry, positions[i].robot_in_zero),
                robot_in_odometry[i]);
}

TEST(ZeroFrame, FirstOdometryIsTheZeroPosition) {
  const Position first_in_odometry{3.0, -2.0, 2.5};
  const ZeroPosition first = follow({first_in_odometry}).front();
  EXPECT_EQ(first.robot_in_zero, Position{});
  EXPECT_EQ(first.zero_in_odometry, first_in_odometry);
  EXPECT_EQ(first.zero_utime, kStart);
  EXPECT_EQ(first.bridged, 0);
  EXPECT_EQ(first.step, OdometryStep::first);
}

TEST(ZeroFrame, FollowsADriveFromZero) {
  const auto positions = follow(drive({}, 200));
  for (std::size_t i = 0; i < positions.size(); ++i)
    expect_near(positions[i].robot_in_zero, move(kDrive, static_cast<double>(i) * kPeriodSeconds));
  EXPECT_EQ(positions.back().bridged, 0);
}

TEST(ZeroFrame, AnyFirstPoseGivesTheSameDrive) {
  const auto from_zero = follow(drive({}, 200));
  for (const Position& start : {Position{40.0, -7.0, kPi}, Position{0.0, 0.1, -kPi + 1e-3},
                                Position{-1.0, 2.0, -kPi / 2.0}}) {
    const auto elsewhere = follow(drive(start, 200));
    for (std::size_t i = 0; i < from_zero.size(); ++i)
      expect_near(elsewhere[i].robot_in_zero, from_zero[i].robot_in_zero);
    EXPECT_EQ(elsewhere.back().bridged, 0);
  }
}

TEST(ZeroFrame, TurningAcrossPiIsNoJump) {
  const Twist spin{.vx = 0.0, .vy = 0.0, .va = -1.2};
  const auto positions = follow(drive({1.0, 1.0, -kPi + 0.2}, 400, spin));  // nearly two turns
  EXPECT_EQ(positions.back().bridged, 0);
  EXPECT_NEAR(positions.back().robot_in_zero.a, wrap_angle(-12.0), kRounding);
}

TEST(ZeroFrame, TeleportIsBridgedByHoldingThePose) {
  auto odometry = drive({2.0, 1.0, 0.3}, 80);
  shift_from(odometry, 40, {0.5, 0.0, 0.0});
  const auto positions = follow(odometry);

  EXPECT_EQ(positions[39].bridged, 0);
  EXPECT_EQ(positions[40].step, OdometryStep::jumped);
  EXPECT_EQ(positions[40].robot_in_zero, positions[39].robot_in_zero);
  EXPECT_EQ(positions.back().bridged, 1);
  EXPECT_EQ(positions.back().zero_utime, kStart);
  expect_continuous(positions);
  expect_consistent(positions, odometry);

  // After it the drive goes on where it was held: one step is lost, and no more.
  const Position after = move(kDrive, 40 * kPeriodSeconds);
  expect_near(positions.back().robot_in_zero, compose(positions[40].robot_in_zero, after));
}

TEST(ZeroFrame, JumpOfTheHeadingAloneIsBridged) {
  auto odometry = drive({2.0, 1.0, 3.0}, 20);
  for (std::size_t i = 10; i < odometry.size(); ++i)
    odometry[i].a = wrap_angle(odometry[i].a + 1.0);  // the heading crosses pi as it jumps
  const auto positions = follow(odometry);
  EXPECT_EQ(positions.back().bridged, 1);
  expect_continuous(positions);
  expect_consistent(positions, odometry);
}

TEST(ZeroFrame, OneBadReadingCostsTheMotionOfTwoSteps) {
  const auto clean = drive({2.0, 1.0, 0.3}, 80);
  auto odometry = clean;
  odometry[40] = {-30.0, 12.0, -2.0};
  const auto expected = follow(clean);
  const auto positions = follow(odometry);

  EXPECT_EQ(positions.back().bridged, 2);
  expect_continuous(positions);
  expect_consistent(positions, odometry);
  const Position offset = relative(expected[41].robot_in_zero, positions[41].robot_in_zero);
  EXPECT_LE(length(offset.location()), 2.0 * kDrivenInPeriod);
  EXPECT_LE(std::abs(offset.a), 2.0 * kTurnedInPeriod + kRounding);
  // From there on the motion is right again.
  expect_near(relative(positions[41].robot_in_zero, positions.back().robot_in_zero),
              relative(expected[41].robot_in_zero, expected.back().robot_in_zero));
}

TEST(ZeroFrame, OneBadReadingLeavesAStandingRobotWhereItIs) {
  std::vector<Position> odometry(20, Position{2.0, 1.0, 0.3});
  odometry[10] = {7.0, 1.0, 0.3};
  for (const ZeroPosition& position : follow(odometry)) expect_near(position.robot_in_zero, {});
}

TEST(ZeroFrame, RobotSwitchedOnAnewIsToldFromAJump) {
  auto odometry = drive({2.0, 1.0, 0.3}, 40);
  const auto again = drive({0.0, 0.0, 0.0}, 40);
  odometry.insert(odometry.end(), again.begin(), again.end());
  const auto positions = follow(odometry);

  EXPECT_EQ(positions[41].step, OdometryStep::switched_on_anew);
  EXPECT_EQ(positions[41].robot_in_zero, positions[40].robot_in_zero);
  EXPECT_EQ(positions.back().bridged, 1);
  EXPECT_EQ(positions.back().zero_utime, kStart);
  expect_continuous(positions);
  expect_near(positions.back().robot_in_zero,
              compose(positions[40].robot_in_zero, move(kDrive, 40 * kPeriodSeconds)));
}

TEST(ZeroFrame, SwitchingOnMayTakeAMinute) {
  ZeroFrame zero_frame;
  zero_frame.update(kStart, {1.0, 0.0, 0.0}, true);
  zero_frame.update(kStart + kPeriod, {1.01, 0.0, 0.0}, false);
  const ZeroPosition again = zero_frame.update(kStart + 60'000'000, {0.0, 0.0, 0.0}, false);
  EXPECT_EQ(again.step, OdometryStep::switched_on_anew);
  expect_near(again.robot_in_zero, {0.01, 0.0, 0.0});
}

TEST(ZeroFrame, DrivingHomeIsNotSwitchingOn) {
  const auto home = drive({1.0, 0.0, 0.0}, 80, {.vx = -0.5, .vy = 0.0, .va = 0.0});
  const auto positions = follow(home);
  EXPECT_EQ(positions.back().bridged, 0);
  expect_near(positions.back().robot_in_zero, {-1.0, 0.0, 0.0});
}

TEST(ZeroFrame, AfterALongSilenceALongWayIsNoJump) {
  const auto positions = follow({{2.0, 1.0, 0.3}, {6.0, 4.0, -2.9}}, 8'000'000);
  EXPECT_EQ(positions.back().step, OdometryStep::driven);
  expect_near(positions.back().robot_in_zero, relative({2.0, 1.0, 0.3}, {6.0, 4.0, -2.9}));
}

TEST(ZeroFrame, NewSessionBeginsWithANewZero) {
  ZeroFrame zero_frame;
  zero_frame.update(kStart, {2.0, 1.0, 0.3}, true);
  zero_frame.update(kStart + kPeriod, {9.0, 1.0, 0.3}, false);
  const ZeroPosition anew = zero_frame.update(500, {9.01, 1.0, 0.3}, true);
  EXPECT_EQ(anew.step, OdometryStep::first);
  EXPECT_EQ(anew.zero_utime, 500);
  EXPECT_EQ(anew.robot_in_zero, Position{});
  EXPECT_EQ(anew.zero_in_odometry, (Position{9.01, 1.0, 0.3}));
  EXPECT_EQ(anew.bridged, 0);
}

TEST(ClassifyStep, BothEndsOfTheBound) {
  const ZeroFrameParameters parameters{.max_speed = 1.0,
                                       .distance_slack = 0.1,
                                       .max_turn_rate = 2.0,
                                       .heading_slack = 0.2,
                                       .origin_radius = 0.05,
                                       .origin_heading = 0.05};
  const Position from{5.0, 5.0, kPi - 0.1};
  const auto after = [&](double x, double a, double seconds) {
    return classify_step(from, {5.0 + x, 5.0, wrap_angle(from.a + a)}, seconds, parameters);
  };
  EXPECT_EQ(after(0.299, 0.0, 0.2), OdometryStep::driven);
  EXPECT_EQ(after(0.301, 0.0, 0.2), OdometryStep::jumped);
  EXPECT_EQ(after(-0.301, 0.0, 0.2), OdometryStep::jumped);
  EXPECT_EQ(after(0.0, 0.599, 0.2), OdometryStep::driven);
  EXPECT_EQ(after(0.0, 0.601, 0.2), OdometryStep::jumped);
  EXPECT_EQ(after(0.0, -0.601, 0.2), OdometryStep::jumped);
}

TEST(ClassifyStep, TimeThatGoesBackwardLeavesTheSlack) {
  const ZeroFrameParameters parameters;
  const Position from{5.0, 5.0, 0.0};
  EXPECT_EQ(classify_step(from, {5.3, 5.0, 0.0}, -1.0, parameters), OdometryStep::driven);
  EXPECT_EQ(classify_step(from, {5.4, 5.0, 0.0}, -1.0, parameters), OdometryStep::jumped);
}

TEST(ClassifyStep, CoarseStampsOfRecordedRobotsAreNoJumps) {
  // The worst steps of recordings: intel (a step in 4.4 ms), csail (odometry that stood still
  // for a second and caught up, once in distance and once in heading), wean (0.8 ms).
  const ZeroFrameParameters parameters;
  const Position from{5.0, 5.0, 1.0};
  EXPECT_EQ(classify_step(from, {5.309, 5.0, 1.0}, 0.0044, parameters), OdometryStep::driven);
  EXPECT_EQ(classify_step(from, {5.945, 5.0, 1.13}, 0.209, parameters), OdometryStep::driven);
  EXPECT_EQ(classify_step(from, {5.467, 5.0, 2.493}, 0.22, parameters), OdometryStep::driven);
  EXPECT_EQ(classify_step(from, {5.058, 5.0, 1.075}, 0.0008, parameters), OdometryStep::driven);
}

}  // namespace
}  // namespace perceptor
