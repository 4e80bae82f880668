#include "tests/support/scene.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace perceptor::test {
namespace {

/// How far a ray from `origin` goes until it meets the piece; infinite where it does not.
double range_to(const Segment& piece, const Vector2& origin, const Vector2& ray) {
  const Vector2 along = piece.b - piece.a;
  const double determinant = cross(ray, along);
  if (determinant == 0.0) return std::numeric_limits<double>::infinity();
  const Vector2 to_piece = piece.a - origin;
  const double range = cross(to_piece, along) / determinant;
  const double share = cross(to_piece, ray) / determinant;
  const bool is_hit = range > 0.0 && share >= 0.0 && share <= 1.0;
  return is_hit ? range : std::numeric_limits<double>::infinity();
}

double nearest_range(const Scene& scene, const Vector2& origin, const Vector2& ray) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Segment& piece : scene) nearest = std::min(nearest, range_to(piece, origin, ray));
  return nearest;
}

}  // namespace

Scene chain(const std::vector<Vector2>& corners) {
  Scene scene;
  for (std::size_t i = 0; i + 1 < corners.size(); ++i)
    scene.push_back({corners[i], corners[i + 1]});
  return scene;
}

Scene room(const std::vector<Vector2>& corners) {
  Scene scene = chain(corners);
  scene.push_back({corners.back(), corners.front()});
  return scene;
}

std::vector<double> fan(std::size_t beams, double first, double last) {
  std::vector<double> bearings;
  for (std::size_t i = 0; i < beams; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(beams - 1);
    bearings.push_back(first + share * (last - first));
  }
  return bearings;
}

std::vector<double> circle(std::size_t beams, double first) {
  std::vector<double> bearings = fan(beams + 1, first, first + 2.0 * std::numbers::pi);
  bearings.pop_back();
  return bearings;
}

SceneLaser pico_laser(double sigma, std::uint64_t seed) {
  return {.bearings = fan(1000, -2.0, 2.0), .laser_in_robot = {}, .sigma = sigma, .seed = seed};
}

LaserScan sweep(const Scene& scene, const SceneLaser& laser, const Position& robot_in_world,
                const Twist& twist) {
  std::mt19937_64 random(laser.seed);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform;

  LaserScan scan;
  scan.laser_in_robot = laser.laser_in_robot;
  scan.valid_min = 0.01;
  scan.valid_max = laser.valid_max;
  scan.range_sigma =
      laser.claimed_sigma >= 0.0 ? laser.claimed_sigma : std::max(laser.sigma, 0.001);
  scan.bearings = laser.bearings;
  if (laser.bearings.size() > 1)
    scan.time_increment = laser.sweep_time / static_cast<double>(laser.bearings.size() - 1);
  for (std::size_t beam = 0; beam < laser.bearings.size(); ++beam) {
    const double seconds = static_cast<double>(beam) * scan.time_increment;
    const Position robot = compose(robot_in_world, move(twist, seconds));
    const Position laser_in_world = compose(robot, laser.laser_in_robot);
    const double direction = laser_in_world.a + laser.bearings[beam];
    const Vector2 ray(std::cos(direction), std::sin(direction));
    double range = nearest_range(scene, laser_in_world.location(), ray);
    range += laser.sigma * normal(random);
    if (uniform(random) < laser.outliers) range = laser.valid_max * uniform(random);
    if (uniform(random) < laser.dropouts) range = 0.0;
    scan.ranges.push_back(range);
  }
  return scan;
}

}  // namespace perceptor::test
