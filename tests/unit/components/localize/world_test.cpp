#include "components/localize/world.hpp"

#include <cmath>

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
  const Met met = world.meet({1.0, 1.0}, {1.0, 0.0});
  EXPECT_DOUBLE_EQ(met.face, 4.0);
  EXPECT_TRUE(std::isinf(met.door));
  EXPECT_DOUBLE_EQ(world.meet({1.0, 3.0}, {1.0, 0.0}).face, 2.0);
  EXPECT_TRUE(std::isinf(world.meet({-1.0, -1.0}, {-1.0, 0.0}).face));
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
  const Met met = world.meet({1.5, 0.0}, {0.0, 1.0});
  EXPECT_TRUE(std::isinf(met.face));
  EXPECT_DOUBLE_EQ(met.door, 2.0);
  EXPECT_TRUE(std::isinf(world.meet({4.5, 0.0}, {0.0, 1.0}).door)) << "too wide";
}

TEST(World, DoorBehindAWallIsNotMet) {
  Map map;
  add_wall(map, {{-1.0, 1.0}, {1.0, 1.0}});
  add_segment(map, {{-1.0, 2.0}, {1.0, 2.0}}, ObjectType::door);
  const Met met = World(map).meet({0.0, 0.0}, {0.0, 1.0});
  EXPECT_DOUBLE_EQ(met.face, 1.0);
  EXPECT_TRUE(std::isinf(met.door));
}

}  // namespace
}  // namespace perceptor::localize
