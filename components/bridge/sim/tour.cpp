#include "components/bridge/sim/tour.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/geometry/angle.hpp"

namespace perceptor::sim {
namespace {

/// A turn in place ends so near to what was asked for [rad].
constexpr double turn_tolerance = 0.01;

}  // namespace

bool TourDriver::is_over() const {
  return !parameters_.loop && reached_ >= static_cast<int>(parameters_.points.size()) &&
         activity_ == Activity::driving;
}

std::optional<int> TourDriver::take_door_request() { return std::exchange(door_request_, {}); }

Twist TourDriver::drive(const Position& robot_in_world, double seconds,
                        const std::vector<Circle>& people) {
  if (parameters_.points.empty() || is_over()) return {};
  switch (activity_) {
    case Activity::turning:
      return turn_on_the_spot(robot_in_world);
    case Activity::pausing:
      return pause(seconds);
    case Activity::driving:
      break;
  }
  return drive_on(robot_in_world, people);
}

Twist TourDriver::drive_on(const Position& robot_in_world, const std::vector<Circle>& people) {
  const Vector2 to_target = target().location - robot_in_world.location();
  const double left = to_target.norm();
  if (left < parameters_.reach) {
    arrive(robot_in_world);
    return {};
  }
  const Vector2 direction = unit(to_target);
  if (gives_way(robot_in_world.location(), direction, people)) return {};

  const double heading_error = angle_difference(robot_in_world.a, angle(direction));
  const double turn_rate = turn_rate_for(heading_error);
  if (std::abs(heading_error) > parameters_.turn_first) return {0.0, 0.0, turn_rate};

  const double can_still_stop = std::sqrt(2.0 * parameters_.acceleration * left);
  const double speed =
      stops_at_target(direction) ? std::min(parameters_.speed, can_still_stop) : parameters_.speed;
  const Vector2 velocity_in_robot =
      perceptor::transform(direction, -robot_in_world.a, Vector2::Zero()) * speed;
  return {velocity_in_robot.x(), velocity_in_robot.y(), turn_rate};
}

void TourDriver::arrive(const Position& robot_in_world) {
  ++reached_;
  if (target().open_door >= 0) door_request_ = target().open_door;
  still_to_turn_ = target().turn;
  still_to_pause_ = target().pause;
  last_heading_ = robot_in_world.a;
  if (still_to_turn_ != 0.0) {
    activity_ = Activity::turning;
  } else if (still_to_pause_ > 0.0) {
    activity_ = Activity::pausing;
  } else {
    go_on();
  }
}

Twist TourDriver::turn_on_the_spot(const Position& robot_in_world) {
  still_to_turn_ -= angle_difference(last_heading_, robot_in_world.a);
  last_heading_ = robot_in_world.a;
  if (std::abs(still_to_turn_) < turn_tolerance) {
    activity_ = Activity::pausing;
    return {};
  }
  return {0.0, 0.0, turn_rate_for(still_to_turn_)};
}

Twist TourDriver::pause(double seconds) {
  still_to_pause_ -= seconds;
  if (still_to_pause_ <= 0.0) go_on();
  return {};
}

void TourDriver::go_on() {
  activity_ = Activity::driving;
  target_ = (target_ + 1) % parameters_.points.size();
}

double TourDriver::turn_rate_for(double heading_error) const {
  return std::clamp(parameters_.gain * heading_error, -parameters_.turn_rate,
                    parameters_.turn_rate);
}

std::optional<Vector2> TourDriver::after_target() const {
  if (target_ + 1 < parameters_.points.size()) return parameters_.points[target_ + 1].location;
  if (parameters_.loop) return parameters_.points.front().location;
  return std::nullopt;
}

bool TourDriver::stops_at_target(const Vector2& direction) const {
  const std::optional<Vector2> next = after_target();
  if (!next || target().turn != 0.0 || target().pause > 0.0) return true;
  const double bend = angle_difference(angle(direction), angle(*next - target().location));
  return std::abs(bend) > parameters_.turn_first;
}

bool TourDriver::gives_way(const Vector2& location, const Vector2& direction,
                           const std::vector<Circle>& people) const {
  return std::any_of(people.begin(), people.end(), [&](const Circle& person) {
    const Vector2 to_person = person.centre - location;
    const double ahead = to_person.dot(direction);
    const double aside = std::abs(cross(direction, to_person));
    return ahead > 0.0 && to_person.norm() < parameters_.gives_way_within &&
           aside < parameters_.gives_way_width;
  });
}

}  // namespace perceptor::sim
