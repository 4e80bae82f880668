/// @file A trial driven through the simulator and all perceiving components.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "common/config/robot.hpp"
#include "common/geometry/pose_estimate.hpp"
#include "components/localize/beam_fit.hpp"
#include "tools/eval/localize/combined_score.hpp"
#include "tools/eval/localize/trial.hpp"
#include "tools/replay/pipeline.hpp"

namespace perceptor {

/// One WORLD_POSITION and the truth of its scan.
struct Fix {
  double time = 0.0;  ///< [s] since the trial began
  Position truth;     ///< robot in world
  PoseEstimate robot_in_world;
  bool is_tracking = false;
  bool is_ambiguous = false;
};

/// What the robot saw from a true pose.
struct TrueView {
  double time = 0.0;  ///< [s] since the trial began, or since it was kidnapped
  Position robot_in_world;
  std::vector<localize::Beam> beams;
};

struct Drive {
  std::vector<Fix> fixes;       ///< of the trial proper
  std::vector<Fix> after;       ///< kidnapped: the time is since then
  std::vector<TrueView> views;  ///< of the trial proper, from poses apart
  std::vector<TrueView> views_after;
  CombinedScore combined;  ///< of the trial proper, while it was tracking rightly
};

/// `mounting`: what the robot's configuration says of the laser. `log`: gets every message of the
/// drive; empty: none.
Drive drive(const Trial& trial, const Site& site, const ProtocolParameters& parameters,
            PipelineConfig config, const LaserMounting& mounting, const std::filesystem::path& log);

}  // namespace perceptor
