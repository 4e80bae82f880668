/// @file Where a robot can drive on a floorplan: a grid, flooded. For tests of maps only.
#pragma once

#include <optional>
#include <vector>

#include "common/floorplan/floorplan.hpp"

namespace perceptor {

class Drivable {
 public:
  /// Cells nearer than `clearance` [m] to a wall, a cabinet or one of `shut`, or inside a
  /// cabinet, are not drivable.
  Drivable(const Floorplan& plan, const std::vector<Segment>& shut, double clearance);

  /// Which connected region a place belongs to; none where it is not drivable.
  std::optional<int> region(const Vector2& place) const;

 private:
  static constexpr double kCell = 0.1;    // [m]
  static constexpr double kMargin = 1.0;  // [m] around the map: whoever leaves it is outside
  static constexpr int kBlocked = -1;
  static constexpr int kUnseen = -2;

  int index(int column, int row) const { return row * columns_ + column; }
  void flood(int start, int region);

  Vector2 corner_ = Vector2::Zero();
  int columns_ = 0;
  int rows_ = 0;
  std::vector<int> cells_;
};

}  // namespace perceptor
