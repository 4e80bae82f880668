#include "common/config/robot.hpp"

#include <numbers>

namespace perceptor {
namespace {

constexpr config::Range kWithinRobot = {-5.0, 5.0};  // [m] a base wider than 10 m is a mistake
constexpr config::Range kHeading = {-std::numbers::pi, std::numbers::pi};

/// Encloses an area, with its outline running counter-clockwise (the shoelace formula).
bool turns_left(const std::vector<FootprintCorner>& corners) {
  double twice_area = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const FootprintCorner& p = corners[i];
    const FootprintCorner& q = corners[(i + 1) % corners.size()];
    twice_area += p.x * q.y - p.y * q.x;
  }
  return twice_area > 0.0;
}

}  // namespace

std::vector<Vector2> outline(const Robot& robot) {
  std::vector<Vector2> corners;
  corners.reserve(robot.footprint.size());
  for (const FootprintCorner& corner : robot.footprint) corners.emplace_back(corner.x, corner.y);
  return corners;
}

void describe(config::Fields& fields, Position& position) {
  constexpr config::Range kPlace = {-1e4, 1e4};
  fields.number("x", position.x, kPlace, "[m] forward");
  fields.number("y", position.y, kPlace, "[m] left");
  fields.number("a", position.a, kHeading, "[rad] heading, counter-clockwise");
}

void describe(config::Fields& fields, FootprintCorner& corner) {
  fields.number("x", corner.x, kWithinRobot, "[m] robot frame");
  fields.number("y", corner.y, kWithinRobot, "[m] robot frame");
}

void describe(config::Fields& fields, RobotLimits& limits) {
  fields.number("speed", limits.speed, {0.01, 10.0}, "[m/s] in any direction");
  fields.number("turn_rate", limits.turn_rate, {0.01, 20.0}, "[rad/s]");
  fields.number("acceleration", limits.acceleration, {0.01, 100.0}, "[m/s^2] in any direction");
  fields.number("angular_acceleration", limits.angular_acceleration, {0.01, 1000.0}, "[rad/s^2]");
}

void describe(config::Fields& fields, LaserMounting& laser) {
  fields.group("laser_in_robot", laser.laser_in_robot, "where the laser is mounted");
  fields.number("range_sigma", laser.range_sigma, {1e-4, 1.0},
                "[m] standard deviation of a valid range");
  fields.number("valid_min", laser.valid_min, {0.0, 100.0}, "[m] shorter is \"no return\"");
  fields.number("valid_max", laser.valid_max, {0.1, 1000.0}, "[m] longer is \"no return\"");
  fields.require(laser.valid_min < laser.valid_max, "valid_min", "less than valid_max");
}

void describe(config::Fields& fields, Robot& robot) {
  fields.list("footprint", robot.footprint,
              "outline of the base, counter-clockwise, at least three corners");
  fields.require(turns_left(robot.footprint), "footprint",
                 "at least three corners, counter-clockwise");
  fields.group("limits", robot.limits, "what the base can do");
  fields.group("laser", robot.laser, "the laser, its place and its noise");
}

}  // namespace perceptor
