#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include "common/runner/runner.hpp"
#include "tools/eval/command.hpp"
#include "tools/eval/random_world.hpp"
#include "tools/eval/world_writer.hpp"
#include "tools/progress.hpp"

namespace perceptor {
namespace {

struct WorldsOptions {
  std::filesystem::path folder;
  std::size_t worlds = 20;
  RandomWorldParameters parameters;
};

/// "world_001"
std::string name_of(std::size_t number) {
  char name[32];
  std::snprintf(name, sizeof name, "world_%03zu", number);
  return name;
}

int make_worlds(const WorldsOptions& options) {
  Progress progress("making", static_cast<std::int64_t>(options.worlds));
  for (std::size_t number = 1; number <= options.worlds; ++number) {
    const RandomWorld world = draw_random_world(options.parameters, number);
    write_random_world(world, options.parameters, number, options.folder, name_of(number));
    progress.at(static_cast<std::int64_t>(number));
  }
  return kExitOk;
}

}  // namespace

Command add_worlds_command(CLI::App& app) {
  const auto options = std::make_shared<WorldsOptions>();
  CLI::App* worlds = app.add_subcommand(
      "worlds",
      "makes random worlds for the simulator: rooms, doorways, furniture, people, a tour");
  RandomWorldParameters& parameters = options->parameters;
  worlds->add_option("OUT", options->folder, "a folder; gets maps/ and worlds/")->required();
  worlds->add_option("--worlds", options->worlds, "how many")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  worlds->add_option("--seed", parameters.seed, "the same seed, the same worlds")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  worlds->add_option("--sigma", parameters.sigma, "[m] standard deviation of a range")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  worlds->add_option("--outliers", parameters.outliers, "share of beams that measure anything")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  worlds
      ->add_option("--slip", parameters.slip, "each axis of odometry is wrong by up to this share")
      ->check(CLI::Range(0.0, 0.5))
      ->capture_default_str();
  worlds->footer(
      "Each world, simulated, perceived and scored:\n"
      "  pico-eval worlds out\n"
      "  for w in out/worlds/*.json; do\n"
      "    pico-bridge --world $w --speed 0 --duration 120 "
      "--lcm-url \"file://${w%.json}.sim?mode=w\"\n"
      "    pico-replay ${w%.json}.sim ${w%.json}.lcmlog\n"
      "  done\n"
      "  pico-eval map out/worlds/*.lcmlog");
  return {worlds, [options] { return make_worlds(*options); }};
}

}  // namespace perceptor
