/// @file What the fake PICO measures: the simulator's world, as the robots of ROS 1 put it. The
/// same options give the same measurements, in the fake robot's own process and in a test.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <random>

#include "components/bridge/sim/simulator.hpp"
#include "tests/process/fake_pico/ros_face.hpp"

namespace perceptor::test {

/// Whose laser, rate and delays.
enum class Model {
  pico,       ///< the real robot: 1081 beams over 270 degrees, in each its own body; 36 Hz
  simulator,  ///< TU/e's: 1000 beams over 4 rad, 30 Hz, uniform noise
  ours,       ///< exactly as the simulator of pico-bridge measures in the same world
};

/// How a beam without return is told.
enum class Miss { zero, infinity, range_max };

struct FakeOptions {
  std::filesystem::path world;  ///< a world file
  Model model = Model::pico;
  Miss miss = Miss::range_max;
  double rate = 0.0;  ///< [Hz] of the laser; 0: the model's own
  sim::Drive drive = sim::Drive::tour;
};

/// What is due at a time, in the order of sending.
class Measurements {
 public:
  /// `base` [ns]: the wall clock at the simulated time 0.
  Measurements(const FakeOptions& options, std::int64_t base);

  struct Due {
    std::int64_t at = 0;  ///< [us] simulated time of sending
    std::optional<RosFace::Scan> scan;
    std::optional<RosFace::Odometry> odometry;
  };

  /// The next one. Commands given before it have their effect.
  Due next();

  sim::Simulator& simulator() { return simulator_; }

 private:
  void advance();
  RosFace::Scan scan_of(const sim::Sweep& sweep);

  FakeOptions options_;
  std::int64_t base_;
  sim::Simulator simulator_;
  std::mt19937_64 random_;
  std::vector<Due> due_;  ///< not yet given
  std::int64_t sweeps_ = 0;
};

}  // namespace perceptor::test
