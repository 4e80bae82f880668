#include "components/identify/identify.hpp"

#include <algorithm>
#include <limits>
#include <numbers>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

#include "tests/unit/components/identify/scene.hpp"

namespace perceptor::identify::test {
namespace {

/// A room with every kind of opening: a door, a doorway with an outer and a loose end, a gap
/// between loose ends, and an end that faces a wall; a pillar inside.
Map busy_room() {
  Map map;
  draw(map, {{0.7, -3.2}, {0.7, -3}, {4, -3}, {4, -0.43}});
  draw(map, {{4, 0.43}, {4, 3}, {1, 3}});
  draw(map, {{0, 3}, {-4, 3}, {-4, -3}, {-0.2, -3}, {-0.2, -3.2}});
  draw(map, {{-1.5, 1.1}, {-3.2, 1.1}});
  draw_ring(map, {{1.5, 1}, {1.5, 1.4}, {1.9, 1.4}, {1.9, 1}});
  end_point(map, 2, 1).method = CornerMethod::spike;
  return map;
}

std::vector<Object> openings_in(const Map& map) {
  std::vector<Object> openings;
  for (const Object& object : map.objects) {
    const bool is_opening =
        object.type == ObjectType::door || object.type == ObjectType::possible_door;
    if (is_opening) openings.push_back(object);
  }
  return openings;
}

/// The same map with its objects and points in another order, and walls drawn the other way.
Map shuffled(const Map& map, std::uint32_t seed) {
  std::mt19937 random(seed);
  const auto permutation = [&random](std::size_t size) {
    std::vector<Index> new_index(size);
    std::iota(new_index.begin(), new_index.end(), 0);
    std::ranges::shuffle(new_index, random);
    return new_index;
  };
  const auto new_point = permutation(map.points.size());
  const auto new_object = permutation(map.objects.size());
  const auto at = [](const std::vector<Index>& indices, Index i) {
    return i == kNone ? kNone : indices[static_cast<std::size_t>(i)];
  };
  Map result = map;
  for (std::size_t i = 0; i < map.points.size(); ++i) {
    Point point = map.points[i];
    point.connected = at(new_point, point.connected);
    for (Index& parent : point.parents) parent = at(new_object, parent);
    result.points[static_cast<std::size_t>(new_point[i])] = point;
  }
  for (std::size_t i = 0; i < map.objects.size(); ++i) {
    Object object = map.objects[i];
    for (Index& point : object.points) point = at(new_point, point);
    if (random() % 2 == 0) {
      std::swap(object.points[0], object.points[1]);
      object.free_side = static_cast<FreeSide>(-static_cast<int>(object.free_side));
    }
    result.objects[static_cast<std::size_t>(new_object[i])] = object;
  }
  return result;
}

TEST(Identify, FindsEveryKindOfOpeningInABusyRoom) {
  Map map = busy_room();
  EXPECT_EQ(identify(map, kRobot), 4U);
  EXPECT_EQ(find_broken_reference(map), "");
  const auto openings = openings_in(map);
  ASSERT_EQ(openings.size(), 4U);
  EXPECT_EQ(openings[0].reason, "two convex corners");
  EXPECT_EQ(openings[1].reason, "outer end and loose end");
  EXPECT_EQ(openings[2].type, ObjectType::possible_door);
  EXPECT_EQ(openings[3].type, ObjectType::possible_door);
}

TEST(Identify, DoorIsAnObjectWithTwoPointsThatReferToTheWallsEnds) {
  Map map = doorway(0.9);
  map.objects[0].weight = 5.0;
  map.objects[0].first_seen = 100;
  map.objects[0].last_seen = 900;
  map.objects[3].weight = 3.0;
  map.objects[3].first_seen = 200;
  map.objects[3].last_seen = 800;
  Point& corner = end_point(map, 0, 1);
  corner.weight = 7.0;
  corner.covariance = 1e-4 * Eigen::Matrix2d::Identity();
  const Map before = map;

  ASSERT_EQ(identify(map, kRobot), 1U);
  ASSERT_EQ(map.objects.size(), before.objects.size() + 1);
  ASSERT_EQ(map.points.size(), before.points.size() + 2);
  const Object& door = map.objects.back();
  EXPECT_EQ(door.type, ObjectType::door);
  EXPECT_EQ(door.name, "door");
  EXPECT_EQ(door.draw_type, DrawType::lines);
  EXPECT_EQ(door.reason, "two convex corners");
  EXPECT_EQ(door.free_side, FreeSide::left);
  EXPECT_NEAR(door.confidence, 1.0, 1e-9);
  EXPECT_EQ(door.weight, 3.0);
  EXPECT_EQ(door.first_seen, 200);
  EXPECT_EQ(door.last_seen, 800);
  EXPECT_NE(door.colour, 0);
  const Point& first = end_point(map, static_cast<Index>(map.objects.size()) - 1, 0);
  const Point& second = end_point(map, static_cast<Index>(map.objects.size()) - 1, 1);
  EXPECT_EQ(first.projection, before.objects[0].points[1]);
  EXPECT_EQ(second.projection, before.objects[3].points[0]);
  EXPECT_EQ(first.weight, 7.0);
  EXPECT_TRUE(first.covariance.has_value());
  EXPECT_EQ(find_broken_reference(map), "");
}

TEST(Identify, PossibleDoorLooksDifferent) {
  Map map = doorway(0.9);
  const Map other = loose_walls(0.9);
  Map possible = other;
  identify(map, kRobot);
  identify(possible, kRobot);
  EXPECT_EQ(possible.objects.back().type, ObjectType::possible_door);
  EXPECT_NE(possible.objects.back().name, map.objects.back().name);
  EXPECT_LE(possible.objects.back().name.size(), kMaxNameLength);
  EXPECT_NE(possible.objects.back().colour, map.objects.back().colour);
  EXPECT_LT(possible.objects.back().confidence, map.objects.back().confidence);
}

TEST(Identify, TurnedEndThatBoundsADoorBecomesConvex) {
  Map map = loose_walls(0.9);
  end_point(map, 0, 1).method = CornerMethod::spike;
  end_point(map, 1, 0).method = CornerMethod::vector;
  identify(map, kRobot);
  EXPECT_EQ(end_point(map, 1, 0).property, PointProperty::convex);
}

TEST(Identify, LastOpeningCanBeTakenOutAgain) {
  Map map = doorway(0.9);
  const std::size_t points = map.points.size();
  const std::size_t objects = map.objects.size();
  ASSERT_EQ(identify(map, kRobot), 1U);
  remove_last_opening(map);
  EXPECT_EQ(map.points.size(), points);
  EXPECT_EQ(map.objects.size(), objects);
  EXPECT_EQ(find_broken_reference(map), "");
}

TEST(Identify, MovingTheSceneMovesTheDoors) {
  Map still = busy_room();
  ASSERT_EQ(identify(still, kRobot), 4U);
  for (int i = 0; i < 36; ++i) {
    const Position map_in_new{0.7 * i, -0.3 * i, i * std::numbers::pi / 18.0 + 0.01};
    Map moved = transform(busy_room(), map_in_new);
    ASSERT_EQ(identify(moved, map_in_new.location()), 4U) << i;
    const Map expected = transform(still, map_in_new);
    for (std::size_t p = 0; p < expected.points.size(); ++p) {
      // Coordinates up to 30 m, rounded a few times.
      EXPECT_LT(distance(moved.points[p].location, expected.points[p].location), 1e-9);
      EXPECT_EQ(moved.points[p].property, expected.points[p].property);
      EXPECT_EQ(moved.points[p].projection, expected.points[p].projection);
    }
    for (std::size_t o = 0; o < expected.objects.size(); ++o) {
      EXPECT_EQ(moved.objects[o].type, expected.objects[o].type);
      EXPECT_EQ(moved.objects[o].reason, expected.objects[o].reason);
      EXPECT_NEAR(moved.objects[o].confidence, expected.objects[o].confidence, 1e-9);
    }
  }
}

TEST(Identify, OrderAndDirectionOfTheWallsChangeNothing) {
  Map drawn = busy_room();
  ASSERT_EQ(identify(drawn, kRobot), 4U);
  const auto expected = openings_in(drawn);
  for (std::uint32_t seed = 0; seed < 100; ++seed) {
    Map map = shuffled(busy_room(), seed);
    ASSERT_EQ(find_broken_reference(map), "");
    ASSERT_EQ(identify(map, kRobot), 4U) << seed;
    const auto openings = openings_in(map);
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_EQ(openings[i].type, expected[i].type);
      EXPECT_EQ(openings[i].reason, expected[i].reason);
      EXPECT_EQ(openings[i].confidence, expected[i].confidence);
      EXPECT_EQ(segment(map, openings[i]).a, segment(drawn, expected[i]).a);
      EXPECT_EQ(segment(map, openings[i]).b, segment(drawn, expected[i]).b);
    }
  }
}

TEST(Identify, OtherObjectsAndLonePointsStayAsTheyAre) {
  Map map = doorway(0.9);
  add_segment(map, {{0, 0}, {0.1, 0}}, ObjectType::origin, "origin");
  add_segment(map, {{-0.2, 2}, {0.2, 2}}, ObjectType::robot, "robot");  // shuts nothing
  Object& ring = map.objects.emplace_back();
  ring.type = ObjectType::safe_distance;
  for (const Vector2& place : {Vector2(1, 0), Vector2(0, 1), Vector2(-1, 0)}) {
    ring.points.push_back(add_point(map, place));
    map.points.back().parents = {static_cast<Index>(map.objects.size()) - 1};
  }
  add_point(map, {1, 1});
  EXPECT_EQ(identify(map, kRobot), 1U);
  EXPECT_EQ(map.objects[4].type, ObjectType::origin);
  EXPECT_EQ(map.objects[6].points.size(), 3U);
  EXPECT_EQ(map.points[map.objects[4].points.size()].parents.size(), 1U);
}

TEST(StrangeMaps, EmptyMapHasNoOpenings) {
  Map map;
  EXPECT_EQ(identify(map, kRobot), 0U);
}

TEST(StrangeMaps, AreLookedAtWithoutHarm) {
  const double huge = std::numeric_limits<double>::max();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Map map = doorway(0.9);
  draw(map, {{0, 2}, {0, 2}});          // no length, in the opening
  draw(map, {{1, 1}, {1, 1}, {1, 1}});  // a corner of them
  draw(map, {{-huge, 0}, {huge, 0}});   // longer than a number can say
  draw(map, {{nan, 0}, {1, nan}});
  draw(map, {{1e200, 0}, {1e200, 1e180}, {0, 1e200}});
  map.objects.emplace_back();                           // a wall without points
  map.objects.emplace_back().points = {0};              // of one point
  map.objects.emplace_back().points = {3, 3};           // of one point twice
  map.objects.emplace_back().points = {-7, 1'000'000};  // of points that are not there
  add_segment(map, {{2, -6}, {2, -5}}, ObjectType::wall);
  map.points.back().connected = 1'000'000;
  add_segment(map, {{-2, 5}, {-2, 6}}, ObjectType::wall);
  const auto last = static_cast<Index>(map.points.size()) - 1;
  map.points[static_cast<std::size_t>(last)].connected = last - 1;  // its own other end
  EXPECT_EQ(identify(map, kRobot), 1U);
  EXPECT_EQ(map.objects.back().type, ObjectType::door);
}

TEST(StrangeMaps, OneSidedAndCircularConnectionsAreNoHarm) {
  Map map = doorway(0.9);
  draw(map, {{1, 1}, {2, 1}});
  draw(map, {{1, 1}, {1, 0}});
  draw(map, {{1, 1}, {0, 1.2}});
  end_point(map, 4, 0).connected = map.objects[5].points[0];
  end_point(map, 5, 0).connected = map.objects[6].points[0];
  end_point(map, 6, 0).connected = map.objects[4].points[0];
  EXPECT_GE(identify(map, kRobot), 1U);
}

TEST(StrangeMaps, LimitsOfZeroAreNoDivision) {
  Map map = doorway(0.9);
  IdentifyParameters parameters;
  parameters.openings.max_angle = 0.0;
  parameters.openings.max_offset = 0.0;
  parameters.openings.door_min_width = 0.9;
  parameters.openings.door_max_width = 0.9;
  identify(map, kRobot, parameters);
  EXPECT_EQ(map.objects.back().type, ObjectType::door);
  EXPECT_NEAR(map.objects.back().confidence, 1.0, 1e-9);
}

}  // namespace
}  // namespace perceptor::identify::test
