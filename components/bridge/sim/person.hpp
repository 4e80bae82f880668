/// @file A person who walks along way-points, there and back.
#pragma once

#include <vector>

#include "components/bridge/sim/random.hpp"
#include "components/bridge/sim/shapes.hpp"

namespace perceptor::sim {

struct PersonParameters {
  std::vector<Vector2> path;    ///< [m] world frame; one point: a person who stands
  double speed = 0.8;           ///< [m/s]
  double radius = 0.25;         ///< [m] of the body, for collisions
  bool two_legs = true;         ///< the laser sees two legs; otherwise one body
  double leg_radius = 0.09;     ///< [m]
  double leg_separation = 0.3;  ///< [m] between the middles of the legs, across
  double stride = 1.3;          ///< [m] walked in one full cycle of the gait
  double step_length = 0.3;     ///< [m] a leg is this far ahead or behind at most
  double waits_within = 1.0;    ///< [m] stands still for a robot ahead that is nearer
  double patience = 3.0;        ///< [s] after so long of waiting, turns back, except at an end
};

class Person {
 public:
  /// Stands at the first way-point; `gait` gives the phase of the first step.
  Person(const PersonParameters& parameters, Random& gait);

  /// Walks for `seconds`, or waits for the robot.
  void advance(double seconds, const Vector2& robot_location);

  Circle body() const { return {location_, parameters_.radius}; }
  Vector2 velocity() const { return velocity_; }  ///< [m/s] world frame

  /// What a laser sees at ankle height.
  std::vector<Circle> legs() const;

 private:
  bool sees_ahead(const Vector2& robot_location) const;
  void walk(double metres);
  void turn_back();
  void face_target();

  PersonParameters parameters_;
  Vector2 location_;
  Vector2 velocity_ = Vector2::Zero();
  Vector2 facing_{1.0, 0.0};
  std::size_t target_ = 0;  ///< index into the path
  bool outbound_ = true;    ///< towards the path's last point
  double phase_ = 0.0;      ///< [rad] of the gait
  double waited_ = 0.0;     ///< [s] since the robot came in the way
};

}  // namespace perceptor::sim
