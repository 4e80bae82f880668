/// @file Hours of a robot's life through the simulator and all perceiving components in one
/// process, nothing kept: does memory grow, do they get slower, do they lose anything?
#pragma once

#include <cstdint>
#include <functional>

#include "components/bridge/sim/simulator.hpp"
#include "tools/replay/pipeline.hpp"

namespace perceptor {

struct SoakParameters {
  double duration = 86'400.0;  ///< [s] of the robot's time
  double period = 600.0;       ///< [s] from one report to the next
  LaserMounting mounting;      ///< as the robot's configuration says
};

/// What happened since the last report.
struct SoakReport {
  double time = 0.0;            ///< [s] of the robot, since the start
  std::int64_t scans = 0;       ///< that went in
  std::int64_t maps = 0;        ///< IDENTIFIED_MAP that came out
  std::int64_t tracked = 0;     ///< WORLD_POSITION that claims to know
  std::int64_t rejected = 0;    ///< by all components, since the start
  std::size_t walls = 0;        ///< of the last local map
  double median_us = 0.0;       ///< of all components together, for a scan
  double p99_us = 0.0;          ///< the same
  double position_error = 0.0;  ///< [m] median of those tracked
  double resident = 0.0;        ///< [MB] of this process
};

void soak(const sim::SimulatorParameters& world, const PipelineConfig& config,
          const SoakParameters& parameters, const std::function<void(const SoakReport&)>& report);

}  // namespace perceptor
