/// @file One trial of the protocol: a building as it really stands, with what the map does not
/// say, and a robot that starts anywhere in it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "components/bridge/sim/simulator.hpp"
#include "tools/eval/localize/site.hpp"
#include "tools/eval/room_random.hpp"

namespace perceptor {

enum class Doors { open, flush, recessed };

/// What is drawn for one trial, one from each list.
struct Conditions {
  double clutter = 0.0;  ///< share of the beams that end on things the map does not have
  int people = 0;        ///< who walk near the start
  Doors doors = Doors::open;
  double slip = 0.0;       ///< each axis of odometry is wrong by a factor of 1 +- up to this
  double sigma = 0.01;     ///< [m] standard deviation of a range
  double outliers = 0.01;  ///< share of the beams that measure anything
  double displaced = 0.0;  ///< [m] the real walls stand off the map by up to this
  bool kidnapped = false;  ///< carried to another start in the end
};

struct ProtocolParameters {
  std::uint64_t seed = 1;
  double duration = 41.0;          ///< [s] 30 to be found in, 10 to be held
  double after_kidnapping = 22.0;  ///< [s] the same
  double kidnapped = 0.25;         ///< share of the trials
  double clearance = 0.36;         ///< [m] that the robot keeps from everything
  double clutter_error = 0.05;     ///< of the share that is asked for
  double recess = 0.08;            ///< [m] of a door that stands back
};

struct Trial {
  std::size_t number = 0;  ///< seed and number give the same trial on every machine
  std::size_t site = 0;
  Conditions conditions;
  sim::SimulatorParameters simulator;
  std::optional<sim::SimulatorParameters> kidnapped_to;  ///< the same world, another start
};

/// `robot`: what the simulator takes from the robot's configuration.
Trial draw_trial(const std::vector<Site>& sites, const sim::SimulatorParameters& robot,
                 const ProtocolParameters& parameters, std::size_t number);

}  // namespace perceptor
