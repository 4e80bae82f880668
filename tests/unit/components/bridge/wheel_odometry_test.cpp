#include "components/bridge/sim/wheel_odometry.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/unit/components/bridge/scenes.hpp"

namespace perceptor::sim {
namespace {

TEST(WheelOdometry, BeginsWhereItWasSwitchedOnAndWrapsItsHeading) {
  OdometryParameters parameters = exact_wheels();
  parameters.start_in_odometry = {3.0, -2.0, 3.1};
  WheelOdometry odometry(parameters, 1);
  EXPECT_EQ(odometry.read(odometry.robot_in_odometry()), (Position{3.0, -2.0, 3.1}));
  odometry.advance({0.0, 0.0, 0.1});
  const Position read = odometry.read(odometry.robot_in_odometry());
  EXPECT_NEAR(read.a, 3.2 - (2.0 * std::numbers::pi), 1e-12);
}

TEST(WheelOdometry, DrivesInItsOwnFrame) {
  OdometryParameters parameters = exact_wheels();
  parameters.start_in_odometry = {1.0, 1.0, std::numbers::pi / 2};
  WheelOdometry odometry(parameters, 1);
  odometry.advance({0.5, 0.0, 0.0});
  EXPECT_NEAR(odometry.robot_in_odometry().x, 1.0, 1e-12);
  EXPECT_NEAR(odometry.robot_in_odometry().y, 1.5, 1e-12);
}

TEST(WheelOdometry, DoesNotSlipWhileItStands) {
  OdometryParameters parameters;
  parameters.slip_walk = parameters.slip_turn_walk = 0.1;
  WheelOdometry odometry(parameters, 7);
  for (int i = 0; i < 1000; ++i) odometry.advance({});
  EXPECT_EQ(odometry.robot_in_odometry(), Position{});
}

TEST(WheelOdometry, ScaleErrorStaysWithinItsBoundAndDiffersBySession) {
  OdometryParameters parameters = exact_wheels();
  parameters.slip_scale = 0.02;
  double least = 1e9;
  double most = -1e9;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    WheelOdometry odometry(parameters, seed);
    for (int i = 0; i < 100; ++i) odometry.advance({0.1, 0.0, 0.0});
    const double error = (odometry.robot_in_odometry().x - 10.0) / 10.0;
    least = std::min(least, error);
    most = std::max(most, error);
  }
  // 200 draws, evenly from [-0.02, 0.02], leave less than a tenth of it out at either end.
  EXPECT_GE(least, -0.02);
  EXPECT_LT(least, -0.018);
  EXPECT_LE(most, 0.02);
  EXPECT_GT(most, 0.018);
}

TEST(WheelOdometry, ScatterGrowsWithTheRootOfTheWayHoweverFinelyCut) {
  OdometryParameters parameters = exact_wheels();
  parameters.slip_walk = 0.01;
  for (const int steps_per_metre : {10, 100}) {
    double sum_of_squares = 0.0;
    const int sessions = 400;
    for (int seed = 1; seed <= sessions; ++seed) {
      WheelOdometry odometry(parameters, static_cast<std::uint64_t>(seed));
      for (int i = 0; i < 4 * steps_per_metre; ++i)
        odometry.advance({1.0 / steps_per_metre, 0.0, 0.0});
      const double error = odometry.robot_in_odometry().x - 4.0;
      sum_of_squares += error * error;
    }
    // 0.01 m/sqrt(m) over 4 m; the deviation of 400 draws is known to 3.5 %, three times that.
    EXPECT_NEAR(std::sqrt(sum_of_squares / sessions), 0.02, 0.0022);
  }
}

TEST(WheelOdometry, NoiseOfAReadingDoesNotAddUp) {
  OdometryParameters parameters = exact_wheels();
  parameters.noise = 0.01;
  WheelOdometry odometry(parameters, 3);
  for (int i = 0; i < 10'000; ++i)
    EXPECT_LT(std::abs(odometry.read(odometry.robot_in_odometry()).x), 0.06);
}

}  // namespace
}  // namespace perceptor::sim
