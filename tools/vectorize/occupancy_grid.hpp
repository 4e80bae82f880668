/// @file A building as cells that are free, occupied or unknown.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "common/geometry/position.hpp"

namespace perceptor {

enum class CellState : std::int8_t { unknown, free, occupied };

struct OccupancyGrid {
  int width = 0;                 ///< cells along x
  int height = 0;                ///< cells along y
  double resolution = 0.05;      ///< [m] side of a cell
  Position grid_in_world;        ///< the outer corner of cell (0, 0)
  std::vector<CellState> cells;  ///< row by row, that of the smallest y first

  /// Unknown outside.
  CellState at(int x, int y) const {
    if (x < 0 || y < 0 || x >= width || y >= height) return CellState::unknown;
    return cells[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                 static_cast<std::size_t>(x)];
  }
};

}  // namespace perceptor
