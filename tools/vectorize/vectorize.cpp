#include "tools/vectorize/vectorize.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "common/floorplan/floorplan_writer.hpp"
#include "common/geometry/polygon.hpp"
#include "tools/vectorize/straighten.hpp"
#include "tools/vectorize/trace.hpp"

namespace perceptor {
namespace {

double length_of(const std::vector<Segment>& pieces) {
  double sum = 0.0;
  for (const Segment& piece : pieces) sum += length(piece);
  return sum;
}

/// [m] of what is occupied behind one place of an outline.
double depth_behind(const OccupancyGrid& grid, const Vector2& place, const Vector2& inward,
                    double most) {
  const double step = grid.resolution / 4.0;
  const Position world_in_grid = inverse(grid.grid_in_world);
  for (int i = 1; i * step <= most; ++i) {
    const Vector2 at = transform(world_in_grid, place + i * step * inward) / grid.resolution;
    const auto x = static_cast<int>(std::floor(at.x()));
    const auto y = static_cast<int>(std::floor(at.y()));
    if (grid.at(x, y) != CellState::occupied) return (i - 1) * step;
  }
  return most;
}

/// [m] from a line along an outline to the middle of the band behind it.
double to_middle(const OccupancyGrid& grid, const Line& line, double thickest) {
  std::vector<double> depths;
  const auto samples = static_cast<int>(line.length / grid.resolution);
  for (int i = 0; i <= samples; ++i) {
    const Vector2 place = point_at(line, i * grid.resolution - line.length / 2.0);
    depths.push_back(depth_behind(grid, place, -line.normal, thickest));
  }
  const auto half = depths.begin() + static_cast<std::ptrdiff_t>(depths.size() / 2);
  std::nth_element(depths.begin(), half, depths.end());
  return *half < thickest ? *half / 2.0 : 0.0;
}

struct Square {
  int x = 0;
  int y = 0;
  int side = 0;  ///< cells
};

/// By dynamic programming: for each cell, the largest square up and right of it.
Square largest_free_square(const OccupancyGrid& grid) {
  std::vector<int> above(static_cast<std::size_t>(grid.width) + 1, 0);
  Square largest;
  for (int y = grid.height - 1; y >= 0; --y) {
    int diagonal = 0;
    for (int x = grid.width - 1; x >= 0; --x) {
      const auto at = static_cast<std::size_t>(x);
      const int up = above[at];
      above[at] =
          grid.at(x, y) == CellState::free ? 1 + std::min({up, above[at + 1], diagonal}) : 0;
      diagonal = up;
      if (above[at] > largest.side) largest = {x, y, above[at]};
    }
  }
  return largest;
}

void add_start_area(const OccupancyGrid& grid, FloorplanBuilder& builder) {
  const Square square = largest_free_square(grid);
  if (square.side < 3) return;
  const int margin = square.side / 3;
  const auto corner = [&](int x, int y) {
    return transform(grid.grid_in_world,
                     grid.resolution * Vector2(static_cast<double>(x), static_cast<double>(y)));
  };
  const int x0 = square.x + margin;
  const int y0 = square.y + margin;
  const int x1 = square.x + square.side - margin;
  const int y1 = square.y + square.side - margin;
  builder.add_start_area(edges({corner(x0, y0), corner(x1, y0), corner(x1, y1), corner(x0, y1)}));
}

}  // namespace

Floorplan vectorize(const OccupancyGrid& grid, const VectorizeParameters& parameters) {
  FloorplanBuilder builder;
  const auto inset = [&](const Line& line) {
    return parameters.surface == Surface::edge ? 0.0 : to_middle(grid, line, parameters.thickest);
  };
  for (const Outline& outline : trace_outlines(grid, parameters.reach)) {
    const auto pieces = straighten(outline, parameters.tolerance * grid.resolution, inset);
    if (length_of(pieces) < parameters.min_length) continue;
    for (const Segment& piece : pieces)
      if (length(piece) > grid.resolution / 2.0) builder.add_wall(piece);
  }
  add_start_area(grid, builder);
  return builder.plan();
}

}  // namespace perceptor
