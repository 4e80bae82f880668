/// @file Which of many lines a ray meets first. The lines are sorted into square cells, and a ray
/// goes from cell to cell (J. Amanatides and A. Woo, "A fast voxel traversal algorithm for ray
/// tracing", Eurographics 1987), over empty space in leaps as wide as it is known to be empty
/// (D. Cohen and Z. Sheffer, "Proximity clouds", The Visual Computer 1994): what a ray costs hardly
/// grows with the building.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "common/geometry/segment.hpp"

namespace perceptor::localize {

struct RayHit {
  std::size_t line = 0;  ///< in the order in which they were added
  double distance = std::numeric_limits<double>::infinity();  ///< [m]; infinite: none is met
  double opening = std::numeric_limits<double>::infinity();   ///< [m]; infinite: none was passed
};

class Rays {
 public:
  void add(const Segment& segment);

  /// A line that rays pass.
  void add_opening(const Segment& segment);

  /// After the last line, before the first ray.
  void sort();

  /// `direction` is a unit vector. Of the openings before the line that is met, the one nearest to
  /// `range` [m] is told.
  RayHit first(const Vector2& origin, const Vector2& direction, double range = 0.0) const;

  /// Calls `take(line)` for each line that may come within `reach` [m] of `place`; for some of them
  /// more than once.
  template <class Take>
  void for_lines_near(const Vector2& place, double reach, const Take& take) const {
    const auto cells = [&](int axis, int count) {
      const double at = place[axis] - corner_[axis];
      return std::pair{std::clamp((at - reach) / cell_, 0.0, static_cast<double>(count)),
                       std::clamp((at + reach) / cell_ + 1.0, 0.0, static_cast<double>(count))};
    };
    const auto [first_column, end_column] = cells(0, columns_);
    const auto [first_row, end_row] = cells(1, rows_);
    for (int row = static_cast<int>(first_row); row < static_cast<int>(end_row); ++row)
      for (int column = static_cast<int>(first_column); column < static_cast<int>(end_column);
           ++column) {
        const Cell& cell = cells_[cell_at(column, row)];
        for (std::uint32_t i = cell.begin; i < cell.openings; ++i) take(in_cells_[i].line);
      }
  }

 private:
  struct Item {
    double ax, ay, dx, dy;  ///< from where, and to the other end [m]
    std::size_t line;
  };

  /// In in_cells_: its lines, then its openings.
  struct Cell {
    std::uint32_t begin, openings, end;
    int leap;  ///< so many cells on in any direction there may be something; at least 1
  };

  static Item item_of(const Segment& segment, std::size_t line);
  static double distance_to(const Item& item, const Vector2& origin, const Vector2& direction);
  std::size_t cell_at(int column, int row) const;
  void lay_cells();
  void add_to_cell(const std::vector<Item>& items, const Vector2& low, const Vector2& high);
  void measure_leaps();

  std::vector<Item> lines_;
  std::vector<Item> openings_;
  Vector2 corner_ = Vector2::Zero();  ///< [m] of the first cell
  double cell_ = 1.0;                 ///< [m] side of a cell
  int columns_ = 0;
  int rows_ = 0;
  std::vector<Cell> cells_;
  std::vector<Item> in_cells_;
};

}  // namespace perceptor::localize
