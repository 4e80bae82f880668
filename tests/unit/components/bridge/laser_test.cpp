#include "components/bridge/sim/laser.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/components/bridge/scenes.hpp"

namespace perceptor::sim {
namespace {

constexpr double half_room = 2.0;

Obstacles square_room_only() { return {square_room(half_room), {}, {}}; }

/// One sweep of a standing robot.
std::vector<float> sweep(Laser& laser, const Obstacles& obstacles,
                         const Position& robot_in_world = {}) {
  laser.sweep({0.0, 1.0, robot_in_world, robot_in_world}, obstacles);
  EXPECT_TRUE(laser.is_complete());
  return laser.take_ranges();
}

std::vector<float> sweep(const LaserParameters& parameters, const Obstacles& obstacles,
                         const Position& robot_in_world = {}) {
  Laser laser(parameters, 1);
  return sweep(laser, obstacles, robot_in_world);
}

/// From the middle of the square room.
double range_in_square(double bearing) {
  return half_room / std::max(std::abs(std::cos(bearing)), std::abs(std::sin(bearing)));
}

TEST(Laser, StandingInARoomSeesExactRanges) {
  const LaserParameters parameters = exact_laser();
  const auto ranges = sweep(parameters, square_room_only());
  ASSERT_EQ(ranges.size(), 1000U);
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const double bearing = -2.0 + (static_cast<double>(i) * angle_increment(parameters));
    EXPECT_NEAR(ranges[i], range_in_square(bearing), 1e-6) << "beam " << i;  // float
  }
}

TEST(Laser, ManyFansAndOneRayAgree) {
  // The culled sweep against each ray on its own, from a crooked place among everything.
  Obstacles world = square_room_only();
  for (const Segment& edge : edges(outline({{0.8, 0.7, 0.4}, 0.5, 0.3})))
    world.segments.push_back(edge);
  world.segments.push_back({{-1.0, -1.5}, {-0.2, -1.7}});
  world.legs = {{{-0.7, 0.6}, 0.1}, {{-0.5, 0.9}, 0.1}, {{0.9, -0.4}, 0.25}};
  LaserParameters parameters = exact_laser();
  parameters.angle_min = -3.1;
  parameters.angle_max = 3.1;
  parameters.laser_in_robot = {0.1, -0.05, 0.2};
  const Position robot_in_world{0.1, 0.2, 1.9};
  const Position laser_in_world = compose(robot_in_world, parameters.laser_in_robot);
  const auto ranges = sweep(parameters, world, robot_in_world);
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const double bearing = laser_in_world.a + parameters.angle_min +
                           (static_cast<double>(i) * angle_increment(parameters));
    EXPECT_NEAR(ranges[i], cast_ray(laser_in_world.location(), bearing, world), 1e-6) << i;
  }
}

TEST(Laser, SweepingWhileTurningPointsEachBeamAtItsOwnTime) {
  const LaserParameters parameters = exact_laser();
  Laser laser(parameters, 1);
  const double turn = 1.2 * 0.02;  // [rad] during the sweep
  laser.sweep({0.0, 0.01, {0.0, 0.0, 0.0}, {0.0, 0.0, turn / 2}}, square_room_only());
  EXPECT_FALSE(laser.is_complete());
  laser.sweep({0.01, 0.02, {0.0, 0.0, turn / 2}, {0.0, 0.0, turn}}, square_room_only());
  ASSERT_TRUE(laser.is_complete());
  const auto ranges = laser.take_ranges();
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const double share = static_cast<double>(i) / 999.0;
    EXPECT_NEAR(ranges[i], range_in_square(-2.0 + (4.0 * share) + (turn * share)), 1e-6);
  }
}

TEST(Laser, ARobotThatTurnsFasterThanItsLaserSweepsStillSeesTheWall) {
  LaserParameters parameters = exact_laser();
  parameters.angle_min = -0.005;
  parameters.angle_max = 0.005;
  parameters.beams = 50;
  Laser laser(parameters, 1);
  const Obstacles post{{{{2.0, -0.02}, {2.0, 0.02}}}, {}, {}};
  laser.sweep({0.0, 0.02, {0.0, 0.0, 0.01}, {0.0, 0.0, -0.01}}, post);
  for (const float range : laser.take_ranges()) EXPECT_NEAR(range, 2.0, 1e-3);
}

TEST(Laser, SweepingWhileDrivingMovesTheOrigin) {
  LaserParameters parameters = exact_laser();
  parameters.beams = 3;
  parameters.angle_min = -0.001;
  parameters.angle_max = 0.001;
  Laser laser(parameters, 1);
  laser.sweep({0.0, 0.02, {0.0, 0.0, 0.0}, {0.1, 0.0, 0.0}}, square_room_only());
  const auto ranges = laser.take_ranges();
  EXPECT_NEAR(ranges[0], 2.0, 1e-5);
  EXPECT_NEAR(ranges[1], 1.95, 1e-5);
  EXPECT_NEAR(ranges[2], 1.9, 1e-5);
}

TEST(Laser, SeesLegsAsCircles) {
  const Obstacles legs{{}, {}, {{{2.0, 0.0}, 0.1}}};
  EXPECT_NEAR(cast_ray({0.0, 0.0}, 0.0, legs), 1.9, 1e-12);
  EXPECT_TRUE(std::isinf(cast_ray({0.0, 0.0}, 0.06, legs)));
  EXPECT_TRUE(std::isinf(cast_ray({0.0, 0.0}, std::numbers::pi, legs)));
  EXPECT_NEAR(cast_ray({2.0, 0.0}, 0.0, legs), 0.1, 1e-12);
}

TEST(Laser, OneBeamIsASweep) {
  LaserParameters parameters = exact_laser();
  parameters.beams = 1;
  parameters.angle_min = 0.0;
  EXPECT_EQ(time_increment(parameters), 0.0);
  EXPECT_EQ(angle_increment(parameters), 0.0);
  const auto ranges = sweep(parameters, square_room_only());
  ASSERT_EQ(ranges.size(), 1U);
  EXPECT_NEAR(ranges[0], 2.0, 1e-6);
}

struct Statistics {
  double mean = 0.0;
  double sigma = 0.0;
  double largest = 0.0;
};

/// Of the errors of 200 sweeps in the square room.
Statistics range_errors(const LaserParameters& parameters) {
  Laser laser(parameters, 5);
  double sum = 0.0;
  double sum_of_squares = 0.0;
  Statistics statistics;
  double count = 0.0;
  for (int n = 0; n < 200; ++n) {
    const auto ranges = sweep(laser, square_room_only());
    for (std::size_t i = 0; i < ranges.size(); ++i) {
      const double bearing = -2.0 + (static_cast<double>(i) * angle_increment(parameters));
      const double error = ranges[i] - range_in_square(bearing);
      sum += error;
      sum_of_squares += error * error;
      statistics.largest = std::max(statistics.largest, std::abs(error));
      count += 1.0;
    }
  }
  statistics.mean = sum / count;
  statistics.sigma = std::sqrt(sum_of_squares / count);
  return statistics;
}

TEST(Laser, GaussianNoiseHasTheSigmaAsked) {
  LaserParameters parameters = exact_laser();
  parameters.noise_sigma = 0.02;
  const Statistics errors = range_errors(parameters);
  // 200 000 draws: the mean is known to 0.02/450, the deviation to 0.16 %; five times that.
  EXPECT_NEAR(errors.mean, 0.0, 0.00025);
  EXPECT_NEAR(errors.sigma, 0.02, 0.00016);
  EXPECT_GT(errors.largest, 0.07);
}

TEST(Laser, UniformNoiseHasTheSameSigmaAndNoTails) {
  LaserParameters parameters = exact_laser();
  parameters.noise_sigma = 0.02;
  parameters.noise = NoiseKind::uniform;
  const Statistics errors = range_errors(parameters);
  EXPECT_NEAR(errors.mean, 0.0, 0.00025);
  EXPECT_NEAR(errors.sigma, 0.02, 0.00016);
  EXPECT_LE(errors.largest, (0.02 * std::numbers::sqrt3) + 1e-6);
}

TEST(Laser, OutliersAndMissedBeamsHaveTheirShare) {
  LaserParameters parameters = exact_laser();
  parameters.outliers = 0.05;
  parameters.missed = 0.02;
  Laser laser(parameters, 9);
  int anywhere = 0;
  int lost = 0;
  for (int n = 0; n < 100; ++n) {
    const auto ranges = sweep(laser, square_room_only());
    for (std::size_t i = 0; i < ranges.size(); ++i) {
      const double bearing = -2.0 + (static_cast<double>(i) * angle_increment(parameters));
      if (std::isinf(ranges[i]))
        ++lost;
      else if (std::abs(ranges[i] - range_in_square(bearing)) > 1e-3)
        ++anywhere;
    }
  }
  // Of 100 000 beams, to five deviations; an outlier may be lost too.
  EXPECT_NEAR(lost, 2000, 225);
  EXPECT_NEAR(anywhere, 4900, 350);
}

TEST(Laser, SwitchingOneThingOnLeavesTheOthersAlone) {
  LaserParameters noisy = exact_laser();
  noisy.noise_sigma = 0.02;
  LaserParameters with_losses = noisy;
  with_losses.missed = 0.1;
  with_losses.outliers = 0.1;
  const auto plain = sweep(noisy, square_room_only());
  const auto lossy = sweep(with_losses, square_room_only());
  const auto same = std::inner_product(plain.begin(), plain.end(), lossy.begin(), 0, std::plus<>(),
                                       [](float p, float q) { return p == q ? 1 : 0; });
  EXPECT_NEAR(same, 810, 65);  // the beams that are neither lost nor anywhere
}

class MissedBeams : public testing::TestWithParam<MissedValue> {
 protected:
  /// Into the open: every beam is missed.
  static std::vector<float> ranges() {
    LaserParameters parameters = exact_laser();
    parameters.missed_value = GetParam();
    return sweep(parameters, {});
  }
};

using MissedBeamsAs = MissedBeams;

TEST_P(MissedBeamsAs, AreEncodedAsAsked) {
  const LaserParameters parameters;
  for (const float range : ranges()) {
    switch (GetParam()) {
      case MissedValue::zero:
        EXPECT_EQ(range, 0.0F);
        break;
      case MissedValue::inf:
        EXPECT_EQ(range, std::numeric_limits<float>::infinity());
        break;
      case MissedValue::nan:
        EXPECT_TRUE(std::isnan(range));
        break;
      case MissedValue::range_max:
        EXPECT_FLOAT_EQ(range, static_cast<float>(parameters.range_max));
        break;
      case MissedValue::range_max_noise:
        EXPECT_NEAR(range, parameters.range_max, 0.0101);
        EXPECT_GT(range, parameters.valid_max);
        break;
      case MissedValue::negative:
        EXPECT_LT(range, 0.0F);
        break;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(AllEncodings, MissedBeamsAs,
                         testing::Values(MissedValue::zero, MissedValue::inf, MissedValue::nan,
                                         MissedValue::range_max, MissedValue::range_max_noise,
                                         MissedValue::negative));

TEST(Laser, AWallBeyondTheSensorsRangeIsMissed) {
  LaserParameters parameters = exact_laser();
  parameters.range_max = 2.2;
  const auto ranges = sweep(parameters, square_room_only());
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const double bearing = -2.0 + (static_cast<double>(i) * angle_increment(parameters));
    EXPECT_EQ(std::isinf(ranges[i]), range_in_square(bearing) > 2.2);
  }
}

}  // namespace
}  // namespace perceptor::sim
