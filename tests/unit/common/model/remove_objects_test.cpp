#include <random>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/model/map.hpp"

namespace perceptor {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<double> xs(const Map& map) {
  std::vector<double> values;
  for (const Point& point : map.points) values.push_back(point.location.x());
  return values;
}

/// Three walls in a row, and a lone corner: each point's x tells which it is.
///
///     0 --- 1   10 --- 11   20 --- 21       30
Map row() {
  Map map;
  for (const double x : {0.0, 10.0, 20.0})
    add_segment(map, {Vector2(x, 0.0), Vector2(x + 1.0, 0.0)}, ObjectType::wall);
  add_point(map, Vector2(30.0, 0.0));
  return map;
}

TEST(RemoveObjects, KeepsAMapWithNothingToRemove) {
  Map map = row();
  connect(map, 1, 2);
  remove_objects(map);
  EXPECT_THAT(xs(map), ElementsAre(0, 1, 10, 11, 20, 21, 30));
  EXPECT_EQ(map.points[1].connected, 2);
  EXPECT_EQ(map.objects.size(), 3U);
}

TEST(RemoveObjects, TakesThePointsWithTheObject) {
  Map map = row();
  map.objects[1].remove = true;
  remove_objects(map);
  EXPECT_THAT(xs(map), ElementsAre(0, 1, 20, 21, 30));
  ASSERT_EQ(map.objects.size(), 2U);
  EXPECT_THAT(map.objects[1].points, ElementsAre(2, 3));
  EXPECT_THAT(map.points[2].parents, ElementsAre(1));
  EXPECT_EQ(find_broken_reference(map), "");
}

TEST(RemoveObjects, RenumbersConnectionsAndProjections) {
  Map map = row();
  connect(map, 1, 4);
  map.points[0].projection = 6;
  map.objects[1].remove = true;
  remove_objects(map);
  EXPECT_EQ(map.points[1].connected, 2);
  EXPECT_EQ(map.points[2].connected, 1);
  EXPECT_EQ(map.points[1].property, PointProperty::connected);
  EXPECT_EQ(map.points[0].projection, 4);
  EXPECT_EQ(find_broken_reference(map), "");
}

TEST(RemoveObjects, APointThatLosesItsConnectionFloats) {
  Map map = row();
  connect(map, 1, 2);
  map.points[1].property = PointProperty::concave;
  map.points[4].projection = 3;
  map.objects[1].remove = true;
  remove_objects(map);
  EXPECT_EQ(map.points[1].connected, kNone);
  EXPECT_EQ(map.points[1].property, PointProperty::floating);
  EXPECT_EQ(map.points[2].projection, kNone);
}

TEST(RemoveObjects, ALoneConvexCornerStaysConvex) {
  Map map = row();
  map.points[6].property = PointProperty::convex;
  for (Object& object : map.objects) object.remove = true;
  remove_objects(map);
  EXPECT_THAT(xs(map), ElementsAre(30));
  EXPECT_THAT(map.objects, IsEmpty());
  EXPECT_EQ(map.points[0].property, PointProperty::convex);
}

TEST(RemoveObjects, KeepsAPointThatAnotherObjectShares) {
  Map map = row();
  Object door;
  door.type = ObjectType::door;
  door.points = {1, 2};
  map.objects.push_back(door);
  map.points[1].parents.push_back(3);
  map.points[2].parents.push_back(3);
  map.objects[0].remove = true;
  map.objects[1].remove = true;
  remove_objects(map);
  EXPECT_THAT(xs(map), ElementsAre(1, 10, 20, 21, 30));
  EXPECT_THAT(map.objects[1].points, ElementsAre(0, 1));
  EXPECT_THAT(map.points[0].parents, ElementsAre(1));
  EXPECT_EQ(find_broken_reference(map), "");
}

TEST(RemoveObjects, MakesNothingOfReferencesThatWereBroken) {
  Map map = row();
  map.points[0].connected = 99;
  map.points[0].projection = -7;
  map.points[6].parents = {55};
  map.objects[2].points = {4, 5, 1234};
  remove_objects(map);
  EXPECT_EQ(map.points[0].connected, kNone);
  EXPECT_EQ(map.points[0].projection, kNone);
  EXPECT_EQ(find_broken_reference(map), "");
}

/// A map of walls and shared doors, with connections and projections wherever they fell.
Map random_map(std::mt19937_64& random) {
  const auto pick = [&random](std::size_t size) { return static_cast<Index>(random() % size); };
  Map map;
  const std::size_t walls = 1 + random() % 12;
  for (std::size_t i = 0; i < walls; ++i) {
    const double x = 10.0 * static_cast<double>(i);
    add_segment(map, {Vector2(x, 0.0), Vector2(x + 1.0, 0.0)}, ObjectType::wall);
  }
  add_point(map, Vector2(-1.0, 0.0));
  for (std::size_t i = 0; i < walls; ++i) {
    connect(map, pick(map.points.size()), pick(map.points.size()));
    const Index from = pick(map.points.size());
    const Index to = pick(map.points.size());
    if (from != to) map.points[static_cast<std::size_t>(from)].projection = to;
  }
  Object door;
  door.points = {0, 1};
  map.objects.push_back(door);
  for (const Index end : door.points)
    map.points[static_cast<std::size_t>(end)].parents.push_back(static_cast<Index>(walls));
  for (Object& object : map.objects) object.remove = random() % 2 == 0;
  return map;
}

TEST(RemoveObjects, KeepsAllReferencesRightWhateverIsRemoved) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 2000; ++i) {
    const Map before = random_map(random);
    ASSERT_EQ(find_broken_reference(before), "");
    Map after = before;
    remove_objects(after);
    ASSERT_EQ(find_broken_reference(after), "");
    std::size_t next = 0;
    for (const Object& object : before.objects) {
      if (object.remove) continue;
      const Segment kept = segment(after, after.objects.at(next++));
      EXPECT_EQ(kept.a, segment(before, object).a);
      EXPECT_EQ(kept.b, segment(before, object).b);
    }
    EXPECT_EQ(after.objects.size(), next);
  }
}

}  // namespace
}  // namespace perceptor
