#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "common/runner/runner.hpp"
#include "components/bridge/world_file.hpp"
#include "tools/eval/command.hpp"
#include "tools/eval/robot_file.hpp"
#include "tools/eval/soak.hpp"

namespace perceptor {
namespace {

namespace fs = std::filesystem;

constexpr double kSecondsPerHour = 3600.0;

struct SoakOptions {
  std::string world = "hospital";
  std::string map = "hospital";
  double hours = 24.0;
  double period = 0.5;  ///< [h]
  fs::path config_dir = default_config_directory();
  std::vector<std::string> overrides;
};

void print(const SoakReport& report) {
  std::printf("%6.2f  %7lld  %6lld  %7lld  %8lld  %5zu  %9.0f  %7.0f  %8.4f  %8.1f\n",
              report.time / kSecondsPerHour, static_cast<long long>(report.scans),
              static_cast<long long>(report.scans - report.maps),
              static_cast<long long>(report.tracked), static_cast<long long>(report.rejected),
              report.walls, report.median_us, report.p99_us, report.position_error,
              report.resident);
  std::fflush(stdout);
}

int run_soak(const SoakOptions& options) {
  const Robot robot = read_robot(options.config_dir);
  const PipelineConfig config =
      load_pipeline_config(options.config_dir, options.overrides, options.map);
  SoakParameters parameters;
  parameters.duration = options.hours * kSecondsPerHour;
  parameters.period = options.period * kSecondsPerHour;
  parameters.mounting = robot.laser;
  std::puts(
      "  time    scans  no map  tracked  rejected  walls  median/us   p99/us  error/m  memory/MB");
  soak(read_world(find_world(options.world, options.config_dir), robot), config, parameters, print);
  return kExitOk;
}

}  // namespace

Command add_soak_command(CLI::App& app) {
  const auto options = std::make_shared<SoakOptions>();
  CLI::App* command = app.add_subcommand(
      "soak", "hours of simulated driving through all components in one process, nothing kept");
  command->add_option("--world", options->world, "of the simulator: a world's name, or its file")
      ->capture_default_str();
  command->add_option("--map", options->map, "the building; \"\": nobody localizes")
      ->capture_default_str();
  command->add_option("--hours", options->hours, "of the robot's time")
      ->check(CLI::Range(0.001, 10'000.0))
      ->capture_default_str();
  command->add_option("--period", options->period, "[h] from one line to the next")
      ->check(CLI::Range(0.001, 1'000.0))
      ->capture_default_str();
  command->add_option("--config-dir", options->config_dir, "folder of the components' JSON files")
      ->capture_default_str();
  command->add_option("--set", options->overrides, "component.key=value")->allow_extra_args(false);
  command->footer(
      "A line each period: hours driven, scans since the last line, how many of them led to no\n"
      "map, how many were localized, messages turned down since the start, walls of the last "
      "local\n"
      "map, the time that all components together take for a scan, localize's median error, and\n"
      "the memory of this process. Memory and times have to stay as they are.\n"
      "Example:\n"
      "  pico-eval soak --hours 24");
  return {command, [options] { return run_soak(*options); }};
}

}  // namespace perceptor
