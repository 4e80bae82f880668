/// @file The simulated world, robot and sensors, in simulated time.
///
/// Time goes on in ticks of some milliseconds. In each, the driver decides, doors and people
/// move, the base moves, the wheels turn, and the laser measures the beams that fall into the
/// tick. All random numbers come from one seed; there is no other source of chance or time.
#pragma once

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "components/bridge/sim/base.hpp"
#include "components/bridge/sim/door.hpp"
#include "components/bridge/sim/laser.hpp"
#include "components/bridge/sim/person.hpp"
#include "components/bridge/sim/tour.hpp"
#include "components/bridge/sim/wheel_odometry.hpp"
#include "components/bridge/velocity_command.hpp"

namespace perceptor::sim {

/// Who drives.
enum class Drive {
  automatic,  ///< the tour, until the first command comes
  tour,       ///< the tour; commands are ignored
  command     ///< commands only
};

struct World {
  std::vector<Segment> walls;     ///< [m] world frame
  std::vector<Segment> cabinets;  ///< edges [m] world frame
  std::vector<DoorParameters> doors;
  std::vector<Box> boxes;
  std::vector<PersonParameters> people;
};

struct SimulatorParameters {
  World world;
  std::int64_t seed = 1;
  std::int64_t start_utime = 1'000'000;  ///< [us] of the simulation's beginning
  std::int64_t tick = 5'000;             ///< [us] finer: straighter slides, more work
  Position start_in_world;               ///< where the robot stands at first
  Drive drive = Drive::automatic;
  double command_lifetime = 0.3;  ///< [s] an older command stops the robot
  BaseParameters base;
  OdometryParameters odometry;
  LaserParameters laser;
  TourParameters tour;
};

struct DoorState {
  Segment opening;
  double open_ratio = 0.0;  ///< 0 shut to 1 open
};

struct MoverState {
  Circle body;
  Vector2 velocity = Vector2::Zero();  ///< [m/s] world frame
};

struct Truth {
  Position robot_in_world;
  Twist twist;  ///< robot frame
  bool in_collision = false;
  std::vector<DoorState> doors;
  std::vector<MoverState> movers;
};

struct OdometryReading {
  std::int64_t utime = 0;
  Position robot_in_odometry;
};

struct Sweep {
  std::int64_t utime = 0;      ///< [us] of the first beam
  std::int64_t completed = 0;  ///< [us] of the last beam, rounded up
  std::vector<float> ranges;   ///< [m]
  Truth truth;                 ///< at utime
};

using Measurement = std::variant<OdometryReading, Sweep>;

class Simulator {
 public:
  /// `tick` > 0, rates > 0, and a sweep shorter than the time between two sweeps.
  explicit Simulator(const SimulatorParameters& parameters);

  std::int64_t utime() const { return utime_; }

  /// The end of the tick in which the next measurement is complete [us].
  std::int64_t next_due() const;

  /// Goes on by one tick, and gives what was measured, in the order of completion.
  std::vector<Measurement> advance();

  /// A driver's wish, resting on what was measured at `measured_at` (none: just now).
  void command(const Twist& wished, std::optional<std::int64_t> measured_at);

  /// Asks for a door; none: the one nearest to the robot of those that open on request. False
  /// where there is no such door.
  bool request_door(std::optional<int> door);

  Truth truth() const;
  const SimulatorParameters& parameters() const { return parameters_; }
  int waypoints_reached() const { return tour_driver_.reached(); }
  bool is_tour_over() const { return tour_driver_.is_over(); }

 private:
  /// What a tick led from and to.
  struct Tick {
    std::int64_t from;
    std::int64_t to;
    Position robot_in_world_from;
    Position robot_in_odometry_from;
  };

  double seconds_since_start() const;
  Twist wished_twist(double seconds);
  void move_world(double seconds);
  void read_wheels(const Tick& tick, std::vector<Measurement>& measured);
  void sweep(const Tick& tick, std::vector<Measurement>& measured);
  std::int64_t next_odometry() const;
  std::int64_t next_sweep() const;

  SimulatorParameters parameters_;
  std::int64_t utime_;
  std::vector<Door> doors_;
  std::vector<Person> people_;
  Base base_;
  WheelOdometry odometry_;
  Laser laser_;
  TourDriver tour_driver_;
  VelocityCommand command_;
  Obstacles obstacles_;
  std::size_t fixed_segments_ = 0;  ///< those that come first and never move
  std::int64_t readings_ = 0;       ///< odometry readings so far
  std::int64_t sweeps_ = 0;         ///< sweeps completed so far
  std::optional<Sweep> sweep_under_way_;
};

}  // namespace perceptor::sim
