/// @file The subcommands of pico-eval.
#pragma once

#include <functional>

#include <CLI/CLI.hpp>

namespace perceptor {

struct Command {
  CLI::App* app;             ///< parsed where the command line names it
  std::function<int()> run;  ///< gives the exit code; throws what run_tool tells
};

/// Scores a recorded log.
Command add_run_command(CLI::App& app);

/// How much of a log's scans its local maps explain.
Command add_explain_command(CLI::App& app);

/// Scores the robot's trajectory in a log.
Command add_trajectory_command(CLI::App& app);

/// Scores the extraction of walls from single scans.
Command add_scan_command(CLI::App& app);

/// Makes a set of scans in random rooms.
Command add_rooms_command(CLI::App& app);

/// Scores local and identified maps of simulated logs.
Command add_map_command(CLI::App& app);

/// Makes random worlds for the simulator.
Command add_worlds_command(CLI::App& app);

/// Scores localize in known buildings, over drawn trials.
Command add_localize_command(CLI::App& app);

/// Hours of simulated driving: memory, times, losses.
Command add_soak_command(CLI::App& app);

}  // namespace perceptor
