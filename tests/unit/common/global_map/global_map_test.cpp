#include "common/global_map/global_map.hpp"

#include <algorithm>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "common/floorplan/floorplan.hpp"
#include "common/geometry/position.hpp"

namespace perceptor::global_map {
namespace {

using Edge = Floorplan::Edge;

/// A room of 4 m by 3 m, one corner at the origin.
Floorplan room() {
  Floorplan plan;
  plan.points = {{0.0, 0.0}, {4.0, 0.0}, {4.0, 3.0}, {0.0, 3.0}};
  plan.walls = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  return plan;
}

/// Adds a closed loop of walls.
void add_loop(Floorplan& plan, const std::vector<Vector2>& corners) {
  const auto first = static_cast<int>(plan.points.size());
  const auto count = static_cast<int>(corners.size());
  plan.points.insert(plan.points.end(), corners.begin(), corners.end());
  for (int i = 0; i < count; ++i) plan.walls.push_back({first + i, first + (i + 1) % count});
}

std::vector<Edge> loop_of(int first, int count) {
  std::vector<Edge> edges;
  for (int i = 0; i < count; ++i) edges.push_back({first + i, first + (i + 1) % count});
  return edges;
}

std::vector<const Object*> objects_of(const Map& map, ObjectType type) {
  std::vector<const Object*> found;
  for (const Object& object : map.objects)
    if (object.type == type) found.push_back(&object);
  return found;
}

/// Each wall has free space on its left: a place 1 cm off its middle.
std::vector<Vector2> places_in_front(const Map& map) {
  std::vector<Vector2> places;
  for (const Object* wall : objects_of(map, ObjectType::wall)) {
    EXPECT_EQ(wall->free_side, FreeSide::left);
    const Segment s = segment(map, *wall);
    places.push_back(middle(s) + 0.01 * perpendicular(direction(s)));
  }
  return places;
}

bool is_in_room(const Vector2& place) {
  return place.x() > 0.0 && place.x() < 4.0 && place.y() > 0.0 && place.y() < 3.0;
}

int count_corners(const Map& map, PointProperty property) {
  return static_cast<int>(std::ranges::count(map.points, property, &Point::property));
}

TEST(GlobalMap, RoomIsFreeInsideAndItsCornersAreConcave) {
  const GlobalMap global = make_global_map(room());
  ASSERT_EQ(global.map.objects.size(), 4U);
  for (const Vector2& place : places_in_front(global.map)) EXPECT_TRUE(is_in_room(place));
  EXPECT_EQ(count_corners(global.map, PointProperty::concave), 8);
  for (const Point& point : global.map.points) EXPECT_NE(point.connected, kNone);
  EXPECT_EQ(find_broken_reference(global.map), "");
  EXPECT_EQ(global.hidden_length, 0.0);
}

TEST(GlobalMap, OrderAndDirectionInTheFileDoNotMatter) {
  Floorplan plan = room();
  add_loop(plan, {{1.0, 1.0}, {1.5, 1.0}, {1.5, 1.5}, {1.0, 1.5}});
  const GlobalMap expected = make_global_map(plan);
  std::mt19937 random(7);
  for (int i = 0; i < 20; ++i) {
    std::ranges::shuffle(plan.walls, random);
    for (Edge& wall : plan.walls)
      if (random() % 2 == 0) std::swap(wall[0], wall[1]);
    EXPECT_EQ(make_global_map(plan).id, expected.id);
  }
}

TEST(GlobalMap, IdIsThatOfTheContents) {
  Floorplan plan = room();
  const std::int64_t id = make_global_map(plan).id;
  EXPECT_GT(id, 0);
  plan.points[2] = {4.0, 3.001};
  EXPECT_NE(make_global_map(plan).id, id);
}

TEST(GlobalMap, AnyPlaceOnEarthWillDo) {
  const Position moved{-37.5, 12.25, 2.0 * std::numbers::pi / 7.0};
  Floorplan plan = room();
  for (Vector2& point : plan.points) point = transform(moved, point);
  const GlobalMap global = make_global_map(plan);
  ASSERT_EQ(global.map.objects.size(), 4U);
  for (const Vector2& place : places_in_front(global.map))
    EXPECT_TRUE(is_in_room(transform(inverse(moved), place)));
}

TEST(GlobalMap, WallThatIsDrawnAsOneLineHasTwoFaces) {
  Floorplan plan = room();
  plan.points.insert(plan.points.end(), {{2.0, 0.0}, {2.0, 2.0}});
  plan.walls.push_back({4, 5});
  const GlobalMap global = make_global_map(plan);
  int at_two = 0;
  for (const Object* wall : objects_of(global.map, ObjectType::wall)) {
    const Segment s = segment(global.map, *wall);
    if (s.a.x() == 2.0 && s.b.x() == 2.0) ++at_two;
  }
  EXPECT_EQ(at_two, 2);
  EXPECT_EQ(count_corners(global.map, PointProperty::convex), 2) << "its end, of either face";
}

TEST(GlobalMap, ThickWallIsSolidInside) {
  Floorplan plan = room();
  add_loop(plan, {{1.9, 0.5}, {2.1, 0.5}, {2.1, 2.5}, {1.9, 2.5}});
  const GlobalMap global = make_global_map(plan);
  ASSERT_EQ(global.map.objects.size(), 8U);
  for (const Vector2& place : places_in_front(global.map))
    EXPECT_FALSE(place.x() > 1.9 && place.x() < 2.1 && place.y() > 0.5 && place.y() < 2.5);
  EXPECT_EQ(count_corners(global.map, PointProperty::convex), 8);
}

TEST(GlobalMap, PillarIsSolidUnlessTheRobotStartsInIt) {
  Floorplan plan = room();
  add_loop(plan, {{1.0, 1.0}, {3.0, 1.0}, {3.0, 2.0}, {1.0, 2.0}});
  EXPECT_EQ(make_global_map(plan).map.objects.size(), 8U);
  plan.points.insert(plan.points.end(), {{1.5, 1.2}, {2.5, 1.2}, {2.5, 1.8}, {1.5, 1.8}});
  plan.start_area = {loop_of(8, 4)};
  const GlobalMap global = make_global_map(plan);
  EXPECT_EQ(objects_of(global.map, ObjectType::wall).size(), 12U) << "both sides of its walls";
  EXPECT_EQ(objects_of(global.map, ObjectType::start_area).size(), 1U);
}

TEST(GlobalMap, OutsideIsFreeWhereTheRobotStartsThere) {
  Floorplan plan = room();
  plan.points.insert(plan.points.end(), {{5.0, 0.0}, {6.0, 0.0}, {6.0, 1.0}, {5.0, 1.0}});
  EXPECT_EQ(objects_of(make_global_map(plan).map, ObjectType::wall).size(), 4U);
  plan.start_area = {loop_of(4, 4)};
  EXPECT_EQ(objects_of(make_global_map(plan).map, ObjectType::wall).size(), 8U);
}

TEST(GlobalMap, FrontOfACabinetIsItsFirstSideWhateverTheOrder) {
  Floorplan plan = room();
  plan.points.insert(plan.points.end(), {{1.0, 1.0}, {2.0, 1.0}, {2.0, 1.5}, {1.0, 1.5}});
  const std::vector<std::vector<Edge>> ways = {{{5, 6}, {6, 7}, {7, 4}, {4, 5}},
                                               {{6, 5}, {4, 5}, {7, 6}, {4, 7}}};
  for (const auto& cabinet : ways) {
    plan.cabinets = {cabinet};
    const GlobalMap global = make_global_map(plan);
    const auto cabinets = objects_of(global.map, ObjectType::cabinet);
    ASSERT_EQ(cabinets.size(), 1U);
    EXPECT_EQ(cabinets[0]->name, "cabinet 0");
    ASSERT_EQ(cabinets[0]->points.size(), 4U);
    const auto corner = [&](std::size_t i) {
      return global.map.points[static_cast<std::size_t>(cabinets[0]->points[i])].location;
    };
    const Segment front{corner(0), corner(1)};
    EXPECT_EQ(middle(front), Vector2(2.0, 1.25));
    EXPECT_GT(perpendicular(direction(front)).x(), 0.0) << "free space on its left";
  }
}

TEST(GlobalMap, DoorEndsAtTheCornersOfItsWalls) {
  Floorplan plan;
  plan.points = {{0.0, 0.0}, {4.0, 0.0}, {4.0, 3.0}, {2.5, 3.0},
                 {1.5, 3.0}, {0.0, 3.0}, {4.0, 6.0}, {0.0, 6.0}};
  plan.walls = {{0, 1}, {1, 2}, {2, 3}, {4, 5}, {5, 0}, {2, 6}, {6, 7}, {7, 5}};
  plan.doors = {{{3, 4}}};
  const GlobalMap global = make_global_map(plan);
  const auto doors = objects_of(global.map, ObjectType::door);
  ASSERT_EQ(doors.size(), 1U);
  for (const Index end : doors[0]->points) {
    const Point& point = global.map.points[static_cast<std::size_t>(end)];
    ASSERT_NE(point.projection, kNone);
    EXPECT_EQ(global.map.points[static_cast<std::size_t>(point.projection)].location,
              point.location);
  }
  EXPECT_EQ(objects_of(global.map, ObjectType::wall).size(), 10U) << "two walls have two faces";
}

TEST(GlobalMap, BuildingThatIsOpenIsFreeInside) {
  // An exit of 0.8 m, without a door.
  Floorplan plan = room();
  plan.walls = {{0, 1}, {1, 2}, {2, 4}, {5, 3}, {3, 0}};
  plan.points.insert(plan.points.end(), {{2.4, 3.0}, {1.6, 3.0}});
  for (const Vector2& place : places_in_front(make_global_map(plan).map))
    EXPECT_TRUE(is_in_room(place));
}

TEST(GlobalMap, LinesThatCrossAreCutThere) {
  Floorplan plan = room();
  plan.points.insert(plan.points.end(), {{2.0, -1.0}, {2.0, 4.0}});
  plan.walls.push_back({4, 5});
  const GlobalMap global = make_global_map(plan);
  EXPECT_EQ(objects_of(global.map, ObjectType::wall).size(), 8U) << "two rooms";
  EXPECT_NEAR(global.hidden_length, 2.0, 1e-9) << "what sticks out is of no use";
}

TEST(GlobalMap, WallDrawnTwiceIsOne) {
  Floorplan plan = room();
  plan.walls.push_back({1, 0});
  EXPECT_EQ(make_global_map(plan).id, make_global_map(room()).id);
}

}  // namespace
}  // namespace perceptor::global_map
