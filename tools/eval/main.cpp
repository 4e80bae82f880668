/// @file pico-eval: scores what the components find.
#include <array>

#include "tools/cli.hpp"
#include "tools/eval/command.hpp"

int main(int argc, char** argv) {
  CLI::App app{
      "Scores a recorded log, walls extracted from single scans, or localize in known buildings;\n"
      "makes such scans, and worlds; soaks.",
      "pico-eval"};
  app.require_subcommand(1);
  const std::array commands = {
      perceptor::add_run_command(app),        perceptor::add_explain_command(app),
      perceptor::add_trajectory_command(app), perceptor::add_scan_command(app),
      perceptor::add_rooms_command(app),      perceptor::add_worlds_command(app),
      perceptor::add_map_command(app),        perceptor::add_localize_command(app),
      perceptor::add_soak_command(app)};
  app.footer(
      "Examples:\n"
      "  pico-eval run build/run/last.lcmlog\n"
      "  pico-eval explain out.lcmlog\n"
      "  pico-eval trajectory out.lcmlog --ref drive.ref --out drive.txt\n"
      "  pico-eval scan tune.scan.gz --method all\n"
      "  pico-eval scan drive.lcmlog --sheet walls.svg\n"
      "  pico-eval scan drive.lcmlog --explain 1200 --bearing 0.3\n"
      "  pico-eval rooms rooms.scan --sigma 0.03 --outliers 0.01 --dropouts 0.01\n"
      "  pico-eval worlds out --worlds 20 --seed 1\n"
      "  pico-eval map out/worlds/*.lcmlog\n"
      "  pico-eval localize config/maps/hospital.json\n"
      "  pico-eval soak --hours 24\n"
      "  pico-eval scan --help");
  return perceptor::run_tool(app, argc, argv, [&] {
    int code = perceptor::kExitOk;
    for (const perceptor::Command& command : commands)
      if (command.app->parsed()) code = command.run();
    return code;
  });
}
