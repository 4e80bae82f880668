/// @file A map file of the Hospital Challenge in its public JSON format.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "common/geometry/segment.hpp"

namespace perceptor {

/// Points, and walls and cabinets that refer to them by index.
struct Floorplan {
  using Edge = std::array<int, 2>;  ///< indices into points

  std::vector<Vector2> points;                ///< [m] world frame
  std::vector<Edge> walls;                    ///< in no particular order or direction
  std::vector<std::vector<Edge>> cabinets;    ///< the first edge is the front
  std::vector<std::vector<Edge>> doors;       ///< optional in the file (2022)
  std::vector<std::vector<Edge>> start_area;  ///< optional in the file (2022)
  std::vector<std::string> ignored;           ///< JSON pointers of keys that are not known

  Segment segment(const Edge& edge) const {
    return {points[static_cast<std::size_t>(edge[0])], points[static_cast<std::size_t>(edge[1])]};
  }
};

/// Throws config::Error (file, JSON pointer, value, what is allowed) where the file cannot be
/// read, nests deeper or is larger than any real one, repeats a key, or holds a point, an index
/// or a cabinet that makes no sense. Unknown keys are ignored, and named in `ignored`.
Floorplan read_floorplan(const std::filesystem::path& file);

}  // namespace perceptor
