#include "components/bridge/ros/velocity_output.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "components/bridge/ros/robot_clock.hpp"

namespace perceptor {
namespace {

constexpr std::int64_t kSecond = 1'000'000;
constexpr std::int64_t kStep = 2'000;
constexpr double kLifetime = 0.28;

struct Said {
  std::int64_t at;
  Twist twist;
};

/// What is said from one time to another.
std::vector<Said> said(VelocityOutput& output, std::int64_t from, std::int64_t to) {
  std::vector<Said> all;
  for (std::int64_t now = from; now < to; now += kStep)
    if (const auto twist = output.due(now)) all.push_back({now, *twist});
  return all;
}

TEST(VelocityOutput, IsSilentUntilSomebodyWishesOrListens) {
  VelocityOutput output({}, kLifetime);
  EXPECT_TRUE(said(output, 0, 5 * kSecond).empty());
}

TEST(VelocityOutput, SaysAWishOnceThenStopsAsItsLifetimeEnds) {
  VelocityOutput output({}, kLifetime);
  EXPECT_FALSE(output.wish({0.4, 0.0, 0.5}, kSecond, kSecond));
  const auto all = said(output, kSecond, 5 * kSecond);
  ASSERT_GE(all.size(), 2U);
  EXPECT_EQ(all[0].at, kSecond);
  EXPECT_EQ(all[0].twist.vx, 0.4);
  EXPECT_EQ(all[0].twist.va, 0.5);
  EXPECT_LE(all[1].at, kSecond + 300'000 - 10'000) << "leaves time for the way to the robot";
  EXPECT_EQ(all[1].twist.vx, 0.0);
}

TEST(VelocityOutput, SaysZeroForASecondAndThenNothing) {
  VelocityOutput output({}, kLifetime);
  output.wish({0.4, 0.0, 0.0}, 0, 0);
  const auto all = said(output, 0, 10 * kSecond);
  EXPECT_EQ(all.size(), 1U + 20U);
  EXPECT_LT(all.back().at, 2 * kSecond);
}

TEST(VelocityOutput, TellsAnotherListenerToStopWhateverItHoldsFromBefore) {
  VelocityOutput output({}, kLifetime);
  output.heard_by_another(3 * kSecond);
  const auto all = said(output, 3 * kSecond, 10 * kSecond);
  ASSERT_EQ(all.size(), 20U);
  EXPECT_EQ(all[0].at, 3 * kSecond);
  for (const Said& zero : all) EXPECT_EQ(zero.twist.vx, 0.0);
}

TEST(VelocityOutput, AnotherListenerDoesNotInterruptTheDriver) {
  VelocityOutput output({}, kLifetime);
  output.wish({0.4, 0.0, 0.0}, 0, 0);
  output.heard_by_another(100'000);
  const auto all = said(output, 100'000, 200'000);
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].twist.vx, 0.4);
}

TEST(VelocityOutput, LimitsAndSaysSo) {
  VelocityOutput output({}, kLifetime);
  EXPECT_TRUE(output.wish({2.0, 0.0, 0.0}, 0, 0));
  EXPECT_EQ(output.due(0)->vx, 0.5);
}

TEST(VelocityOutput, AWishThatRestsOnOldMeasurementsStopsTheRobot) {
  VelocityOutput output({}, kLifetime);
  output.wish({0.4, 0.0, 0.0}, kSecond, kSecond);
  EXPECT_EQ(output.due(kSecond)->vx, 0.4);
  output.wish({0.4, 0.0, 0.0}, kSecond / 2, kSecond + kStep);
  EXPECT_EQ(output.due(kSecond + kStep)->vx, 0.0);
}

TEST(RobotClock, AMeasurementIsAsOldAsTheTimeSinceTheNewestCameAndWhatLiesBetween) {
  RobotClock clock;
  EXPECT_EQ(clock.arrival(77, 5 * kSecond), 5 * kSecond) << "nothing has come";
  clock.saw(1'000 * kSecond, 5 * kSecond);
  EXPECT_EQ(clock.arrival(1'000 * kSecond, 6 * kSecond), 5 * kSecond);
  EXPECT_EQ(clock.arrival(999 * kSecond, 6 * kSecond), 4 * kSecond);
  EXPECT_EQ(clock.arrival(2'000 * kSecond, 6 * kSecond), 6 * kSecond) << "none from the future";
}

TEST(RobotClock, ThatWasSetBackBeginsAnew) {
  RobotClock clock;
  clock.saw(1'000 * kSecond, 5 * kSecond);
  clock.saw(1'000 * kSecond - 50'000, 5 * kSecond + 10'000);  // the other sensor, a little older
  EXPECT_EQ(clock.arrival(1'000 * kSecond, 6 * kSecond), 5 * kSecond);
  clock.saw(10 * kSecond, 6 * kSecond);
  EXPECT_EQ(clock.arrival(10 * kSecond, 7 * kSecond), 6 * kSecond);
}

}  // namespace
}  // namespace perceptor
