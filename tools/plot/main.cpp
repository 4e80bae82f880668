/// @file pico-plot: the viewer's picture from a log, without a browser.
#include <cstdio>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "common/text/format.hpp"
#include "tools/cli.hpp"
#include "tools/plot/drawing.hpp"
#include "tools/plot/log_scene.hpp"

namespace perceptor {
namespace {

struct PlotOptions {
  std::filesystem::path log;
  std::filesystem::path out = "plot.png";
  double at = std::numeric_limits<double>::infinity();
  std::vector<std::string> hidden;
  DrawingOptions drawing;
};

viewer::Layer layer_named(const std::string& id) {
  std::string all;
  for (std::size_t i = 0; i < viewer::kLayers; ++i) {
    if (viewer::kLayerLooks[i].id == id) return static_cast<viewer::Layer>(i);
    all += (i > 0 ? ", " : "") + std::string(viewer::kLayerLooks[i].id);
  }
  throw config::Error("--hide " + id + ": no such layer; allowed: " + all);
}

int plot(PlotOptions options) {
  for (const std::string& id : options.hidden) options.drawing.hidden.insert(layer_named(id));
  const LogScene found = scene_of_log(options.log, options.at);
  draw(found.scene, options.out, options.drawing);
  std::printf("%s: after %.1f s of robot time, %s frame\n", options.out.c_str(), found.seconds,
              std::string(name(found.scene.frame)).c_str());
  for (const std::string& note : found.scene.notes) std::printf("  %s\n", note.c_str());
  if (found.rejected > 0)
    std::fprintf(stderr, "pico-plot: %lld bad messages passed over\n",
                 static_cast<long long>(found.rejected));
  return kExitOk;
}

}  // namespace
}  // namespace perceptor

int main(int argc, char** argv) {
  perceptor::PlotOptions options;
  CLI::App app{"Draws what the viewer would show at one moment of a log, with its legend.",
               "pico-plot"};
  app.add_option("log", options.log, "an LCM log with what the components published")
      ->required()
      ->check(CLI::ExistingFile);
  app.add_option("--at", options.at,
                 "[s] of robot time after the first measurement; default: the log's end")
      ->check(CLI::NonNegativeNumber);
  app.add_option("--out", options.out, "the picture: FILE.png or FILE.svg")->capture_default_str();
  app.add_option("--hide", options.hidden, "layers to leave out: truth,beams,...")->delimiter(',');
  app.add_option("--around", options.drawing.around,
                 "[m] shown on each side of the robot; default: everything")
      ->check(CLI::PositiveNumber);
  app.add_option("--width", options.drawing.width, "[px] of the picture")
      ->capture_default_str()
      ->check(CLI::Range(400, 20000));
  app.add_option("--height", options.drawing.height, "[px] of the picture")
      ->capture_default_str()
      ->check(CLI::Range(300, 20000));
  app.footer(
      "Example:\n"
      "  tools/run --duration 60 && pico-plot build/run/last.lcmlog --at 30 --out hospital.svg\n"
      "A log of raw measurements becomes one with maps by pico-replay.");
  return perceptor::run_tool(app, argc, argv, [&] { return perceptor::plot(options); });
}
