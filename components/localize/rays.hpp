/// @file Which of many lines a ray meets first. The lines are sorted into square cells, and a ray
/// goes from cell to cell (J. Amanatides and A. Woo, "A fast voxel traversal algorithm for ray
/// tracing", Eurographics 1987): what a ray costs hardly grows with the building.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "common/geometry/segment.hpp"

namespace perceptor::localize {

struct RayHit {
  std::size_t line = 0;  ///< in the order in which they were added
  double distance = std::numeric_limits<double>::infinity();  ///< [m]; infinite: none is met
};

class Rays {
 public:
  void add(const Segment& segment);

  /// After the last line, before the first ray.
  void sort();

  /// `direction` is a unit vector.
  RayHit first(const Vector2& origin, const Vector2& direction) const;

 private:
  struct Item {
    double ax, ay, dx, dy;  ///< from where, and to the other end [m]
    std::size_t line;
  };

  static double distance_to(const Item& item, const Vector2& origin, const Vector2& direction);
  std::size_t cell_at(int column, int row) const;

  std::vector<Item> lines_;
  Vector2 corner_ = Vector2::Zero();  ///< [m] of the first cell
  double cell_ = 1.0;                 ///< [m] side of a cell
  int columns_ = 0;
  int rows_ = 0;
  std::vector<std::size_t> begins_;  ///< for each cell and one more: where its lines begin
  std::vector<Item> in_cells_;       ///< the lines of each cell, cell after cell
};

}  // namespace perceptor::localize
