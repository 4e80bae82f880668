/// @file pico-vectorize: turns a picture of a building into a map file.
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "common/floorplan/floorplan_writer.hpp"
#include "tools/cli.hpp"
#include "tools/vectorize/read_grid.hpp"
#include "tools/vectorize/vectorize.hpp"

namespace perceptor {
namespace {

struct VectorizeOptions {
  std::filesystem::path in;
  std::filesystem::path out;
  ImageMeaning image;
  std::vector<double> origin = {0.0, 0.0, 0.0};
  std::string surface;  ///< empty: what the kind of file suggests
  VectorizeParameters parameters;
};

bool is_yaml(const std::filesystem::path& file) {
  return file.extension() == ".yaml" || file.extension() == ".yml";
}

int vectorize_file(VectorizeOptions options) {
  options.image.origin = {options.origin[0], options.origin[1], options.origin[2]};
  const OccupancyGrid grid =
      is_yaml(options.in) ? read_map_server(options.in) : read_image(options.in, options.image);
  if (options.surface == "middle" || (options.surface.empty() && is_yaml(options.in)))
    options.parameters.surface = Surface::middle;
  const Floorplan plan = vectorize(grid, options.parameters);
  if (plan.walls.empty())
    throw std::runtime_error(options.in.string() +
                             ": no occupied cell beside a free one: no walls (see " +
                             (is_yaml(options.in) ? "its negate, occupied_thresh, free_thresh)"
                                                  : "--negate, --occupied, --free)"));
  write_floorplan(plan, "From " + options.in.filename().string(), options.out);
  std::cerr << "pico-vectorize: " << grid.width << " x " << grid.height << " cells, "
            << plan.walls.size() << " walls\n";
  return kExitOk;
}

}  // namespace
}  // namespace perceptor

int main(int argc, char** argv) {
  perceptor::VectorizeOptions options;
  CLI::App app{
      "Turns an occupancy grid (a YAML file of ROS's map_server with its image) or a plain image\n"
      "(as TU/e's height maps) into a map file of the Hospital Challenge. Dark is occupied.",
      "pico-vectorize"};
  app.add_option("IN", options.in, "map.yaml, or an image: PNG, PGM, ...")
      ->required()
      ->check(CLI::ExistingFile);
  app.add_option("OUT", options.out, "the map file to write, JSON")->required();
  CLI::App* image = app.add_option_group("Plain image", "A YAML file tells these itself");
  image->add_option("--resolution", options.image.resolution, "[m] side of a pixel")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  image
      ->add_option("--origin", options.origin,
                   "x y a of its lower left corner, in the world [m, rad]")
      ->expected(3);
  image->add_flag("--negate", options.image.negate, "white is occupied");
  image->add_option("--occupied", options.image.occupied_thresh, "as dark as this: occupied")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  image->add_option("--free", options.image.free_thresh, "lighter than this: free")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  app.add_option("--tolerance", options.parameters.tolerance,
                 "cells by which a wall may be off its outline")
      ->check(CLI::Range(0.1, 100.0))
      ->capture_default_str();
  app.add_option("--min-length", options.parameters.min_length, "[m] shorter outlines are specks")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  app.add_option("--surface", options.surface,
                 "of walls: the edge of what is occupied, or its middle, for maps made of scans,\n"
                 "which smear a wall (default: middle for YAML, edge for plain images)")
      ->check(CLI::IsMember({"edge", "middle"}));
  app.add_option("--reach", options.parameters.reach,
                 "unknown cells between what is free and what is occupied")
      ->check(CLI::Range(0, 100))
      ->capture_default_str();
  app.footer(
      "The map gets a small start area in the middle of the widest free space, which tells inside\n"
      "from outside where the walls do not close.\n"
      "Examples:\n"
      "  pico-vectorize map.yaml building.json &&\n"
      "    pico-localize --config config/localize_scanned_map.json --map building.json\n"
      "  pico-vectorize heightmap.png building.json --resolution 0.025");
  return perceptor::run_tool(app, argc, argv, [&] {
    if (perceptor::is_yaml(options.in) && image->count_all() > 0)
      throw CLI::ValidationError("IN", "a YAML file tells itself what a plain image is asked for");
    return perceptor::vectorize_file(options);
  });
}
