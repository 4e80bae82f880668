#include "components/localize/world.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/unit/components/localize/building.hpp"

namespace perceptor::localize {
namespace {

void add_wall(Map& map, const Segment& wall, FreeSide free_side = FreeSide::left) {
  const Index index = add_segment(map, wall, ObjectType::wall);
  map.objects[static_cast<std::size_t>(index)].free_side = free_side;
}

TEST(World, RayMeetsTheNearestFace) {
  const World world(angled_room().map);
  const Met met = world.meet({1.0, 1.0}, {1.0, 0.0}, 4.0);
  EXPECT_DOUBLE_EQ(met.face, 4.0);
  EXPECT_TRUE(std::isinf(met.door));
  EXPECT_DOUBLE_EQ(world.meet({1.0, 3.0}, {1.0, 0.0}, 4.0).face, 2.0);
  EXPECT_TRUE(std::isinf(world.meet({-1.0, -1.0}, {-1.0, 0.0}, 4.0).face));
}

TEST(World, FreeSideSaysWhichWayAFaceRuns) {
  Map map;
  add_wall(map, {{0.0, 0.0}, {1.0, 0.0}}, FreeSide::right);
  add_wall(map, {{0.0, 5.0}, {1.0, 5.0}}, FreeSide::unknown);
  const World world(map);
  ASSERT_EQ(world.faces().size(), 3U);
  EXPECT_EQ(world.faces()[0].segment.a, Vector2(1.0, 0.0));
  EXPECT_EQ(world.faces()[1].segment.a, Vector2(0.0, 5.0));
  EXPECT_EQ(world.faces()[2].segment.a, Vector2(1.0, 5.0));
}

TEST(World, GapAsWideAsADoorMayBeShut) {
  Map map;
  add_wall(map, {{0.0, 2.0}, {1.0, 2.0}});
  add_wall(map, {{2.0, 2.0}, {3.0, 2.0}});
  add_wall(map, {{6.0, 2.0}, {7.0, 2.0}});
  const World world(map);
  ASSERT_EQ(world.fronts().size(), 1U);
  EXPECT_EQ(world.fronts()[0].pieces.size(), 3U);
  ASSERT_EQ(world.fronts()[0].gaps.size(), 1U);
  EXPECT_DOUBLE_EQ(world.fronts()[0].gaps[0].length(), 1.0);
  const Met met = world.meet({1.5, 0.0}, {0.0, 1.0}, 4.0);
  EXPECT_TRUE(std::isinf(met.face));
  EXPECT_DOUBLE_EQ(met.door, 2.0);
  EXPECT_TRUE(std::isinf(world.meet({4.5, 0.0}, {0.0, 1.0}, 4.0).door)) << "too wide";
}

TEST(World, OfTheOpeningsThatABeamPassesTheOneNearestToItsRangeMayBeShut) {
  Map map;
  for (const double face : {2.0, 2.2}) {
    add_wall(map, {{0.0, face}, {1.0, face}}, FreeSide::unknown);
    add_wall(map, {{2.0, face}, {3.0, face}}, FreeSide::unknown);
  }
  add_wall(map, {{0.0, 4.0}, {3.0, 4.0}}, FreeSide::right);
  const World world(map);
  EXPECT_NEAR(world.meet({1.5, 0.0}, {0.0, 1.0}, 1.9).door, 2.0, 1e-9);
  EXPECT_NEAR(world.meet({1.5, 0.0}, {0.0, 1.0}, 2.3).door, 2.2, 1e-9);
  EXPECT_NEAR(world.meet({1.5, 0.0}, {0.0, 1.0}, 9.0).door, 2.2, 1e-9) << "none behind a face";
}

TEST(World, DoorBehindAWallIsNotMet) {
  Map map;
  add_wall(map, {{-1.0, 1.0}, {1.0, 1.0}});
  add_segment(map, {{-1.0, 2.0}, {1.0, 2.0}}, ObjectType::door);
  const Met met = World(map).meet({0.0, 0.0}, {0.0, 1.0}, 2.0);
  EXPECT_DOUBLE_EQ(met.face, 1.0);
  EXPECT_TRUE(std::isinf(met.door));
}

/// Two rooms, one above the other, a wall of 0.2 m between them with a doorway from 1 to 2.
Map rooms_with_thick_wall() {
  Map map;
  add_wall(map, {{0.0, 2.0}, {1.0, 2.0}}, FreeSide::right);
  add_wall(map, {{2.0, 2.0}, {3.0, 2.0}}, FreeSide::right);
  add_wall(map, {{0.0, 2.2}, {1.0, 2.2}});
  add_wall(map, {{2.0, 2.2}, {3.0, 2.2}});
  add_wall(map, {{1.0, 2.0}, {1.0, 2.2}}, FreeSide::right);
  add_wall(map, {{2.0, 2.0}, {2.0, 2.2}});
  return map;
}

TEST(World, OpeningsInBothFacesOfAWallAreOneDoorway) {
  Map map = rooms_with_thick_wall();
  const World world(map);
  ASSERT_EQ(world.doorways().size(), 1U);
  const Doorway& doorway = world.doorways().front();
  EXPECT_NEAR(doorway.half_depth, 0.1, 1e-12);
  EXPECT_LT(distance(middle(doorway.opening), Vector2(1.5, 2.1)), 1e-12);
  EXPECT_DOUBLE_EQ(length(doorway.opening), 1.0);

  add_segment(map, {{1.0, 2.0}, {2.0, 2.0}}, ObjectType::door);
  EXPECT_EQ(World(map).doorways().size(), 1U) << "drawn as well";
}

TEST(World, WhereDoorsAreDrawnOtherGapsAreNone) {
  Map map = rooms_with_thick_wall();
  add_segment(map, {{5.0, 5.0}, {6.0, 5.0}}, ObjectType::door);
  const World world(map);
  ASSERT_EQ(world.doorways().size(), 1U);
  EXPECT_EQ(world.doorways().front().opening.a, Vector2(5.0, 5.0));
  EXPECT_FALSE(world.fronts().front().gaps.empty()) << "it may be shut all the same";
}

TEST(World, NicheIsNoDoorway) {
  Map map;
  add_wall(map, {{0.0, 2.0}, {1.0, 2.0}}, FreeSide::right);
  add_wall(map, {{2.0, 2.0}, {3.0, 2.0}}, FreeSide::right);
  add_wall(map, {{1.0, 2.4}, {2.0, 2.4}}, FreeSide::right);
  EXPECT_TRUE(World(map).doorways().empty());
}

TEST(World, CornerThatIsCutOffIsNoDoorway) {
  Map map;
  add_wall(map, {{0.0, 2.0}, {1.0, 2.0}}, FreeSide::right);
  add_wall(map, {{1.0, 2.0}, {1.8, 2.6}}, FreeSide::right);
  add_wall(map, {{2.0, 2.0}, {3.0, 2.0}}, FreeSide::right);
  EXPECT_TRUE(World(map).doorways().empty());
}

TEST(World, NoDoorHangsOnACabinet) {
  Map map;
  add_wall(map, {{0.0, 2.0}, {1.0, 2.0}}, FreeSide::right);
  Object cabinet;
  cabinet.type = ObjectType::cabinet;
  cabinet.connection = Connection::closed;
  for (const Vector2& corner :
       {Vector2(2.0, 2.0), Vector2(2.0, 2.5), Vector2(3.0, 2.5), Vector2(3.0, 2.0)})
    cabinet.points.push_back(add_point(map, corner));
  map.objects.push_back(cabinet);
  EXPECT_TRUE(World(map).doorways().empty());
}

TEST(World, FrontsAreFoundByTheirDirection) {
  const World world(angled_room().map);
  const auto count = [&](double angle) {
    int fronts = 0;
    world.for_fronts_along(angle, 0.1, [&](const Front&) { ++fronts; });
    return fronts;
  };
  EXPECT_EQ(count(0.0), 1);
  EXPECT_EQ(count(std::numbers::pi), 2) << "upper walls at 2 m and 4 m";
  EXPECT_EQ(count(-std::numbers::pi), 2);
  EXPECT_EQ(count(std::numbers::pi + 0.05 + 2.0 * std::numbers::pi), 2);
  EXPECT_EQ(count(0.7), 0);
}

}  // namespace
}  // namespace perceptor::localize
