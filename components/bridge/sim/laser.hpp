/// @file A laser that sweeps: each beam is cast from where the laser is at the beam's own time.
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "components/bridge/sim/obstacles.hpp"
#include "components/bridge/sim/random.hpp"

namespace perceptor::sim {

enum class NoiseKind { gaussian, uniform };

/// What the sensor reports for a beam that does not return.
enum class MissedValue { zero, inf, nan, range_max, range_max_noise, negative };

struct LaserParameters {
  Position laser_in_robot;
  int beams = 1000;                             ///< 1 to 10 000
  double angle_min = -2.0;                      ///< [rad] bearing of the first beam
  double angle_max = 2.0;                       ///< [rad] bearing of the last beam
  double rate = 40.0;                           ///< [Hz] sweeps
  double sweep_time = 0.02;                     ///< [s] from the first beam to the last
  double valid_min = 0.01;                      ///< [m] smallest outlier
  double valid_max = 10.0;                      ///< [m] largest outlier
  double range_max = 10.02;                     ///< [m] beyond it a beam is missed
  double noise_sigma = 0.01;                    ///< [m] standard deviation of a range
  NoiseKind noise = NoiseKind::gaussian;        ///< its distribution
  double outliers = 0.0;                        ///< share of returns that are anywhere
  double missed = 0.0;                          ///< share of returns that are lost
  MissedValue missed_value = MissedValue::inf;  ///< how a missed beam is reported
  double missed_noise = 0.01;                   ///< [m] of range_max_noise, to either side
};

/// [rad] from beam to beam; 0 for a single beam.
double angle_increment(const LaserParameters& parameters);

/// [s] from beam to beam; 0 for a single beam.
double time_increment(const LaserParameters& parameters);

/// The first beam that one ray hits, by its distance [m]; infinite where it hits nothing.
double cast_ray(const Vector2& origin, double bearing, const Obstacles& obstacles);

class Laser {
 public:
  Laser(const LaserParameters& parameters, std::uint64_t seed);

  /// The robot's way over a short time.
  struct Stretch {
    double from = 0.0;  ///< [s] since the sweep's first beam
    double to = 0.0;    ///< [s]
    Position robot_in_world_from;
    Position robot_in_world_to;
  };

  /// Measures the beams up to the time `to` that are not yet measured, the robot moving evenly
  /// between the two poses.
  void sweep(const Stretch& stretch, const Obstacles& obstacles);

  /// Whether all beams are measured.
  bool is_complete() const { return ranges_.size() == static_cast<std::size_t>(parameters_.beams); }

  /// The ranges measured [m], in the order of the beams; the next sweep begins.
  std::vector<float> take_ranges();

 private:
  struct Ray {
    Vector2 origin;
    Vector2 direction;
  };
  /// The laser's own way, in the world.
  struct Path {
    double from;  ///< [s] since the sweep's first beam
    double to;    ///< [s]
    Position laser_at_from;
    Position laser_at_to;
    double turn;  ///< [rad] from the one to the other
  };
  Path laser_path(const Stretch& stretch) const;
  Ray ray(std::size_t beam, const Path& path) const;
  void measure(std::size_t first, std::size_t last, const Path& path, const Obstacles& obstacles);
  double reported(double distance);
  double missed_value();

  LaserParameters parameters_;
  std::vector<float> ranges_;
  Random noise_random_;
  Random outlier_random_;
  Random missed_random_;
  Random missed_value_random_;
  std::normal_distribution<double> normal_;
};

}  // namespace perceptor::sim
