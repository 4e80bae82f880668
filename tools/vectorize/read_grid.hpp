/// @file Occupancy grids from files: those of ROS's map_server (an image and a YAML file), and
/// plain images such as TU/e's height maps.
#pragma once

#include <filesystem>

#include "tools/vectorize/occupancy_grid.hpp"

namespace perceptor {

/// How an image is meant; map_server's names (http://wiki.ros.org/map_server).
struct ImageMeaning {
  double resolution = 0.025;      ///< [m] side of a pixel
  Position origin;                ///< outer corner of the lower left pixel, in the world
  bool negate = false;            ///< white is occupied
  double occupied_thresh = 0.65;  ///< as dark as this share and darker is occupied
  double free_thresh = 0.196;     ///< lighter is free
};

/// PNG, PGM and what else stb_image reads. Throws config::Error.
OccupancyGrid read_image(const std::filesystem::path& image, const ImageMeaning& meaning);

/// The YAML file of map_server, and the image that it names. Throws config::Error.
OccupancyGrid read_map_server(const std::filesystem::path& yaml);

}  // namespace perceptor
