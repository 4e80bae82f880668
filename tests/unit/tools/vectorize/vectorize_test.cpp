#include "tools/vectorize/vectorize.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "common/global_map/global_map.hpp"
#include "tests/unit/tools/vectorize/drawn_grid.hpp"

namespace perceptor {
namespace {

constexpr double kCell = 0.05;  // [m]

/// Cells within a band along a line are occupied, others inside the frame free.
OccupancyGrid painted(const std::vector<Segment>& lines, double half_thickness, int size = 80) {
  OccupancyGrid grid;
  grid.width = grid.height = size;
  grid.resolution = kCell;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const Vector2 middle = kCell * Vector2(x + 0.5, y + 0.5);
      const bool is_near = std::ranges::any_of(
          lines, [&](const Segment& line) { return distance(line, middle) <= half_thickness; });
      grid.cells.push_back(is_near ? CellState::occupied : CellState::free);
    }
  return grid;
}

double length_of(const Floorplan& plan) {
  double sum = 0.0;
  for (const Floorplan::Edge& wall : plan.walls) sum += length(plan.segment(wall));
  return sum;
}

TEST(Vectorize, RoomDrawnInCellsHasItsWalls) {
  std::vector<std::string> rows(30, "#" + std::string(38, '.') + "#");
  rows.front() = rows.back() = std::string(40, '#');
  const Floorplan plan = vectorize(drawn(rows));
  ASSERT_EQ(plan.walls.size(), 4U);
  EXPECT_NEAR(length_of(plan), 2.0 * (3.8 + 2.8), 1e-9);
  for (const Vector2& point : plan.points)
    EXPECT_TRUE(point.x() > 0.05 && point.x() < 3.95 && point.y() > 0.05 && point.y() < 2.95)
        << point.transpose();
  EXPECT_EQ(plan.start_area.size(), 1U);
}

TEST(Vectorize, SlantedWallIsStraight) {
  const Segment line{{0.7, 0.9}, {3.2, 1.9}};
  const Floorplan plan = vectorize(painted({line}, 0.06));
  const auto longest = std::ranges::max_element(
      plan.walls, {}, [&](const auto& e) { return length(plan.segment(e)); });
  const Segment wall = plan.segment(*longest);
  EXPECT_NEAR(smallest_relative_angle(wall, line), 0.0, 0.02);
  EXPECT_NEAR(distance(line, middle(wall)), 0.06, kCell);
  EXPECT_GT(length(wall), 2.2);
}

TEST(Vectorize, MiddleOfASmearedWall) {
  const Segment line{{0.3, 2.0}, {3.7, 2.0}};
  VectorizeParameters parameters;
  parameters.surface = Surface::middle;
  const Floorplan plan = vectorize(painted({line}, 0.2), parameters);
  double off = 0.0;
  for (const Floorplan::Edge& edge : plan.walls)
    if (length(plan.segment(edge)) > 2.0)
      off = std::max(off, std::abs(middle(plan.segment(edge)).y() - 2.0));
  EXPECT_LT(off, 0.03);
}

TEST(Vectorize, SpecksAreLeftOut) {
  const Floorplan plan = vectorize(drawn({"......", "..#...", "......"}, 0.05));
  EXPECT_TRUE(plan.walls.empty());
}

TEST(Vectorize, GlobalMapKnowsWhichSideIsFree) {
  std::vector<std::string> rows(30, "#" + std::string(38, '.') + "#");
  rows.front() = rows.back() = std::string(40, '#');
  rows[10][0] = rows[11][0] = ' ';  // a hole that nobody looked through
  const Map map = global_map::make_global_map(vectorize(drawn(rows))).map;
  int walls = 0;
  for (const Object& object : map.objects)
    if (object.type == ObjectType::wall) {
      const Segment wall = segment(map, object);
      if (signed_distance(wall, {2.0, 1.5}) > 0.0) ++walls;
    }
  EXPECT_GE(walls, 4);
}

}  // namespace
}  // namespace perceptor
