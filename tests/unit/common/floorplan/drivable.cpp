#include "tests/unit/common/floorplan/drivable.hpp"

#include <algorithm>
#include <cmath>

#include "common/geometry/polygon.hpp"

namespace perceptor {
namespace {

struct Obstacles {
  std::vector<Segment> edges;
  std::vector<std::vector<Vector2>> bodies;
};

Obstacles obstacles_of(const Floorplan& plan, const std::vector<Segment>& shut) {
  Obstacles result{shut, {}};
  for (const Floorplan::Edge& wall : plan.walls) result.edges.push_back(plan.segment(wall));
  for (const auto& cabinet : plan.cabinets) {
    auto& body = result.bodies.emplace_back();
    for (const Floorplan::Edge& edge : cabinet) {
      result.edges.push_back(plan.segment(edge));
      body.push_back(plan.segment(edge).a);
    }
  }
  return result;
}

bool is_free(const Obstacles& obstacles, const Vector2& place, double clearance) {
  const auto is_near = [&](const Segment& edge) { return distance(edge, place) < clearance; };
  const auto is_inside = [&](const auto& body) { return contains(body, place); };
  return std::none_of(obstacles.edges.begin(), obstacles.edges.end(), is_near) &&
         std::none_of(obstacles.bodies.begin(), obstacles.bodies.end(), is_inside);
}

}  // namespace

Drivable::Drivable(const Floorplan& plan, const std::vector<Segment>& shut, double clearance) {
  Vector2 low = plan.points.front();
  Vector2 high = low;
  for (const Vector2& point : plan.points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  corner_ = low - Vector2(kMargin, kMargin);
  const Vector2 size = high - low + 2.0 * Vector2(kMargin, kMargin);
  columns_ = static_cast<int>(std::ceil(size.x() / kCell));
  rows_ = static_cast<int>(std::ceil(size.y() / kCell));

  const Obstacles obstacles = obstacles_of(plan, shut);
  for (int row = 0; row < rows_; ++row)
    for (int column = 0; column < columns_; ++column) {
      const Vector2 middle = corner_ + kCell * Vector2(column + 0.5, row + 0.5);
      cells_.push_back(is_free(obstacles, middle, clearance) ? kUnseen : kBlocked);
    }
  int regions = 0;
  for (int i = 0; i < columns_ * rows_; ++i)
    if (cells_[static_cast<std::size_t>(i)] == kUnseen) flood(i, regions++);
}

void Drivable::flood(int start, int region) {
  std::vector<int> open = {start};
  while (!open.empty()) {
    const int here = open.back();
    open.pop_back();
    int& cell = cells_[static_cast<std::size_t>(here)];
    if (cell != kUnseen) continue;
    cell = region;
    const int column = here % columns_;
    const int row = here / columns_;
    if (column > 0) open.push_back(index(column - 1, row));
    if (column + 1 < columns_) open.push_back(index(column + 1, row));
    if (row > 0) open.push_back(index(column, row - 1));
    if (row + 1 < rows_) open.push_back(index(column, row + 1));
  }
}

std::optional<int> Drivable::region(const Vector2& place) const {
  const Vector2 cell = (place - corner_) / kCell;
  const int column = static_cast<int>(std::floor(cell.x()));
  const int row = static_cast<int>(std::floor(cell.y()));
  const bool is_on_grid = column >= 0 && column < columns_ && row >= 0 && row < rows_;
  if (!is_on_grid) return std::nullopt;
  const int found = cells_[static_cast<std::size_t>(index(column, row))];
  return found == kBlocked ? std::nullopt : std::optional(found);
}

}  // namespace perceptor
