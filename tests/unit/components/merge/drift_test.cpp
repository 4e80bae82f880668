#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "common/geometry/angle.hpp"
#include "tests/unit/components/merge/scene.hpp"

namespace perceptor::merge {
namespace {

/// Around a room in an ellipse, once in 30 s, looking ahead.
Position tour(double seconds) {
  const double phase = 2.0 * std::numbers::pi * seconds / 30.0;
  return {2.0 + 1.2 * std::cos(phase), 1.5 + 0.8 * std::sin(phase),
          wrap_angle(std::atan2(0.8 * std::cos(phase), -1.2 * std::sin(phase)))};
}

/// Odometry that says 3 % too much of the way, and turns 0.02 rad too much each metre.
Position drifting(const Position& odometry, const Position& motion) {
  const double way = std::hypot(motion.x, motion.y);
  return compose(odometry, {1.03 * motion.x, 1.03 * motion.y, motion.a + 0.02 * way});
}

std::vector<Drawn> noisy(const std::vector<Drawn>& scene, std::mt19937_64& random) {
  std::normal_distribution<double> offset(0.0, 0.002);
  std::vector<Drawn> seen = scene;
  for (Drawn& drawn : seen) {
    const Vector2 across = perpendicular(direction(drawn.segment));
    drawn.segment.a += offset(random) * across;
    drawn.segment.b += offset(random) * across;
  }
  return seen;
}

struct Outcome {
  double distance = 0.0;  ///< [m] largest error of the pose
  double heading = 0.0;   ///< [rad]
  double odometry = 0.0;  ///< [m] error of odometry at the end
  std::size_t walls = 0;
};

Outcome drive(Session& session, double rate, double seconds) {
  std::mt19937_64 random(7);
  Position odometry = tour(0.0);
  Outcome outcome;
  const int scans = static_cast<int>(seconds * rate);
  for (int i = 0; i < scans; ++i) {
    const Position truth = tour(i / rate);
    if (i > 0) odometry = drifting(odometry, relative(tour((i - 1) / rate), truth));
    session.wait(1.0 / rate - kScanPeriod * 1e-6);
    const Map scan = transform(draw(noisy(room(), random)), inverse(truth));
    const LocalMap local = session.take(scan, odometry);
    EXPECT_FALSE(local.rejected) << i;
    const Position& pose = local.robot_in_local.pose;
    outcome.distance = std::max(outcome.distance, distance(pose.location(), truth.location()));
    outcome.heading = std::max(outcome.heading, std::abs(angle_difference(truth.a, pose.a)));
    outcome.odometry = distance(odometry.location(), truth.location());
    outcome.walls = local.walls.objects.size();
  }
  return outcome;
}

class Drift : public testing::TestWithParam<double> {};

TEST_P(Drift, OfOdometryIsTakenOutInARoom) {
  Session session;
  const Outcome outcome = drive(session, GetParam(), 120.0);
  EXPECT_GT(outcome.odometry, 0.2);  // it did drift
  EXPECT_LT(outcome.distance, 0.01);
  EXPECT_LT(outcome.heading, 0.3 * std::numbers::pi / 180.0);
  EXPECT_EQ(outcome.walls, 4U);
  EXPECT_EQ(session.walls().size(), 4U);
}

INSTANTIATE_TEST_SUITE_P(Rates, Drift, testing::Values(2.0, 10.0, 40.0), [](const auto& rate) {
  return std::to_string(static_cast<int>(rate.param)) + "Hz";
});

}  // namespace
}  // namespace perceptor::merge
