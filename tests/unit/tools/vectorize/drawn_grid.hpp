/// @file Occupancy grids drawn with letters.
#pragma once

#include <string>
#include <vector>

#include "tools/vectorize/occupancy_grid.hpp"

namespace perceptor {

/// '#' occupied, '.' free, ' ' unknown; the first row is the highest.
inline OccupancyGrid drawn(const std::vector<std::string>& rows, double resolution = 0.1) {
  OccupancyGrid grid;
  grid.width = static_cast<int>(rows.front().size());
  grid.height = static_cast<int>(rows.size());
  grid.resolution = resolution;
  for (auto row = rows.rbegin(); row != rows.rend(); ++row)
    for (const char letter : *row)
      grid.cells.push_back(letter == '#'   ? CellState::occupied
                           : letter == '.' ? CellState::free
                                           : CellState::unknown);
  return grid;
}

}  // namespace perceptor
