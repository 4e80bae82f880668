#include "components/bridge/sim/tour.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "components/bridge/sim/base.hpp"
#include "tests/unit/components/bridge/scenes.hpp"

namespace perceptor::sim {
namespace {

constexpr double tick = 0.005;  // [s]

struct Ride {
  explicit Ride(const TourParameters& tour) : driver(tour), base(parameters(), {}) {}

  static BaseParameters parameters() {
    BaseParameters parameters;
    parameters.footprint = square_footprint();
    return parameters;
  }
  void go(double seconds, const std::vector<Circle>& people = {}) {
    for (double time = 0.0; time < seconds; time += tick)
      base.advance(driver.drive(base.robot_in_world(), tick, people), tick, {});
  }

  TourDriver driver;
  Base base;
};

TourParameters tour_of(std::vector<Waypoint> points, bool loop) {
  TourParameters parameters;
  parameters.points = std::move(points);
  parameters.loop = loop;
  return parameters;
}

TEST(Tour, ReachesEachWaypointAndStopsAtTheLast) {
  Ride ride(tour_of({{{1.0, 0.0}}, {{1.0, 1.0}}}, false));
  ride.go(10.0);
  EXPECT_EQ(ride.driver.reached(), 2);
  EXPECT_TRUE(ride.driver.is_over());
  EXPECT_NEAR(distance(ride.base.robot_in_world().location(), {1.0, 1.0}), 0.0, 0.05);
  EXPECT_EQ(ride.base.twist().vx, 0.0);
}

TEST(Tour, LoopsForEver) {
  Ride ride(tour_of({{{0.5, 0.0}}, {{0.0, 0.5}}}, true));
  ride.go(60.0);
  EXPECT_GT(ride.driver.reached(), 10);
  EXPECT_FALSE(ride.driver.is_over());
}

TEST(Tour, KeepsToTheLineBetweenWaypoints) {
  Ride ride(tour_of({{{1.0, 0.3}}, {{2.0, 0.6}}}, false));
  const Segment line{{0.0, 0.0}, {2.0, 0.6}};
  for (int i = 0; i < 1400; ++i) {
    ride.go(tick / 2);
    EXPECT_LT(distance(line, ride.base.robot_in_world().location()), 0.05);
  }
  EXPECT_TRUE(ride.driver.is_over());
}

TEST(Tour, TurnsInPlaceAsFarAsAsked) {
  Ride ride(tour_of({{{0.01, 0.0}, -2.0 * std::numbers::pi}}, false));
  double turned = 0.0;
  double last = 0.0;
  for (int i = 0; i < 2000; ++i) {
    ride.go(tick / 2);
    turned += std::remainder(ride.base.robot_in_world().a - last, 2.0 * std::numbers::pi);
    last = ride.base.robot_in_world().a;
  }
  EXPECT_NEAR(turned, -2.0 * std::numbers::pi, 0.02);
}

TEST(Tour, PausesAndAsksForTheDoor) {
  Ride ride(tour_of({{{0.01, 0.0}, 0.0, 3.0, 4}, {{1.0, 0.0}}}, false));
  ride.go(0.1);
  EXPECT_EQ(ride.driver.take_door_request(), 4);
  EXPECT_FALSE(ride.driver.take_door_request().has_value());
  ride.go(2.7);
  EXPECT_LT(ride.base.robot_in_world().x, 0.01);
  ride.go(4.0);
  EXPECT_TRUE(ride.driver.is_over());
}

TEST(Tour, WaitsForAPersonAheadButNotForOneBeside) {
  Ride ride(tour_of({{{3.0, 0.0}}}, false));
  ride.go(4.0, {{{2.0, 0.1}, 0.25}});
  EXPECT_NEAR(ride.base.robot_in_world().x, 1.1, 0.1);  // 1 m before, and some way to stop
  ride.go(6.0, {{{2.0, 0.6}, 0.25}});
  EXPECT_TRUE(ride.driver.is_over());
}

TEST(Tour, WithoutWaypointsStaysWhereItIs) {
  Ride ride(tour_of({}, true));
  ride.go(1.0);
  EXPECT_EQ(ride.base.robot_in_world(), Position{});
}

}  // namespace
}  // namespace perceptor::sim
