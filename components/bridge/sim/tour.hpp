/// @file Drives the simulated robot along way-points. It looks at the truth: it stands for a
/// careful driver, not for a navigation algorithm.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "common/geometry/twist.hpp"
#include "components/bridge/sim/shapes.hpp"

namespace perceptor::sim {

struct Waypoint {
  Vector2 location = Vector2::Zero();  ///< [m] world frame
  double turn = 0.0;                   ///< [rad] turned in place after arrival; positive: left
  double pause = 0.0;                  ///< [s] stood still after that
  int open_door = -1;                  ///< door that is asked for on arrival; -1: none
};

struct TourParameters {
  std::vector<Waypoint> points;
  bool loop = true;               ///< from the last way-point to the first again
  double speed = 0.5;             ///< [m/s] along the way
  double turn_rate = 1.0;         ///< [rad/s]
  double acceleration = 0.8;      ///< [m/s^2] with which it slows down; below the base's own
  double gain = 2.0;              ///< [1/s] turn rate for each radian of heading error
  double reach = 0.05;            ///< [m] so near a way-point is reached
  double turn_first = 0.35;       ///< [rad] a larger heading error is turned away on the spot
  double gives_way_within = 1.0;  ///< [m] waits for a person ahead who is nearer
  double gives_way_width = 0.5;   ///< [m] ahead means so far aside at most
};

class TourDriver {
 public:
  explicit TourDriver(TourParameters parameters) : parameters_(std::move(parameters)) {}

  /// The velocity to wish for, in the robot frame, for the coming `seconds`.
  Twist drive(const Position& robot_in_world, double seconds, const std::vector<Circle>& people);

  /// The door that the driver asks for since it was last asked.
  std::optional<int> take_door_request();

  /// Way-points reached so far; goes on counting when the tour loops.
  int reached() const { return reached_; }

  /// All way-points are reached, and the tour does not loop.
  bool is_over() const;

 private:
  enum class Activity { driving, turning, pausing };

  Twist drive_on(const Position& robot_in_world, const std::vector<Circle>& people);
  Twist turn_on_the_spot(const Position& robot_in_world);
  Twist pause(double seconds);
  void arrive(const Position& robot_in_world);
  void go_on();
  double turn_rate_for(double heading_error) const;
  bool stops_at_target(const Vector2& direction) const;
  bool gives_way(const Vector2& location, const Vector2& direction,
                 const std::vector<Circle>& people) const;
  const Waypoint& target() const { return parameters_.points[target_]; }
  std::optional<Vector2> after_target() const;

  TourParameters parameters_;
  Activity activity_ = Activity::driving;
  std::size_t target_ = 0;
  int reached_ = 0;
  double last_heading_ = 0.0;    ///< [rad] while turning
  double still_to_turn_ = 0.0;   ///< [rad]
  double still_to_pause_ = 0.0;  ///< [s]
  std::optional<int> door_request_;
};

}  // namespace perceptor::sim
