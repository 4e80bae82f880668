#include "components/bridge/sim/person.hpp"

#include <cmath>
#include <numbers>

namespace perceptor::sim {

Person::Person(const PersonParameters& parameters, Random& gait)
    : parameters_(parameters), location_(parameters.path.front()) {
  phase_ = std::uniform_real_distribution<double>(0.0, 2.0 * std::numbers::pi)(gait);
  if (parameters_.path.size() > 1) target_ = 1;
  face_target();
}

void Person::advance(double seconds, const Vector2& robot_location) {
  velocity_ = Vector2::Zero();
  if (parameters_.path.size() < 2) return;
  if (sees_ahead(robot_location)) {
    waited_ += seconds;
    if (waited_ > parameters_.patience) turn_back();
    return;
  }
  waited_ = 0.0;
  const Vector2 before = location_;
  walk(parameters_.speed * seconds);
  velocity_ = (location_ - before) / seconds;
}

bool Person::sees_ahead(const Vector2& robot_location) const {
  const Vector2 to_robot = robot_location - location_;
  return to_robot.norm() < parameters_.waits_within && to_robot.dot(facing_) > 0.0;
}

void Person::walk(double metres) {
  const Vector2 to_target = parameters_.path[target_] - location_;
  const double left = to_target.norm();
  if (left > metres) {
    location_ += facing_ * metres;
    phase_ += 2.0 * std::numbers::pi * metres / parameters_.stride;
    return;
  }
  location_ = parameters_.path[target_];
  const bool at_an_end = outbound_ ? target_ + 1 == parameters_.path.size() : target_ == 0;
  if (at_an_end) outbound_ = !outbound_;
  target_ = outbound_ ? target_ + 1 : target_ - 1;
  face_target();
}

void Person::turn_back() {
  waited_ = 0.0;
  const bool outbound = !outbound_;
  std::size_t target = outbound ? target_ + 1 : target_ - 1;
  if (location_ == parameters_.path[target]) {
    const bool is_at_an_end = outbound ? target + 1 == parameters_.path.size() : target == 0;
    if (is_at_an_end) return;  // nowhere else to go
    target = outbound ? target + 1 : target - 1;
  }
  outbound_ = outbound;
  target_ = target;
  face_target();
}

void Person::face_target() {
  const Vector2 to_target = parameters_.path[target_] - location_;
  if (to_target.norm() > 0.0) facing_ = unit(to_target);
}

std::vector<Circle> Person::legs() const {
  if (!parameters_.two_legs) return {body()};
  const Vector2 aside = perpendicular(facing_) * (parameters_.leg_separation / 2.0);
  const Vector2 ahead = facing_ * (parameters_.step_length * std::sin(phase_));
  return {{location_ + aside + ahead, parameters_.leg_radius},
          {location_ - aside - ahead, parameters_.leg_radius}};
}

}  // namespace perceptor::sim
