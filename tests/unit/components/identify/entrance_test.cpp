#include "components/identify/entrance.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "tests/unit/components/identify/scene.hpp"

namespace perceptor::identify::test {
namespace {

/// Places are computed from the walls' ends.
constexpr double kExact = 1e-9;
constexpr double kUp = 0.5 * std::numbers::pi;
constexpr std::int64_t kNow = 100'000'000;  // [us]

std::vector<Exit> exits_of(Map map, const Vector2& robot = kRobot) {
  identify(map, robot);
  return find_exits(map, read_walls(map), robot, kNow);
}

TEST(Exits, DoorwayLeadsOutOfTheRoom) {
  const auto exits = exits_of(room_with_doorway());
  ASSERT_EQ(exits.size(), 1U);
  EXPECT_NEAR(distance(exits[0].middle, {0, 2}), 0.0, kExact);
  EXPECT_NEAR(exits[0].direction, kUp, kExact);
  EXPECT_NEAR(exits[0].width, 0.9, kExact);
  EXPECT_NEAR(exits[0].confidence, 1.0, kExact);
}

TEST(Exits, DoorThatTheRobotHasGoneThroughIsNone) {
  EXPECT_EQ(exits_of(room_with_doorway(), {0, 1.9}).size(), 1U);
  EXPECT_TRUE(exits_of(room_with_doorway(), {0, 2.1}).empty());
}

TEST(Exits, DoorOutOfReachIsNone) {
  Map map = room_with_doorway();
  identify(map, kRobot);
  const auto exits_within = [&](double max_distance) {
    return find_exits(map, read_walls(map), kRobot, kNow, {.max_distance = max_distance}).size();
  };
  EXPECT_EQ(exits_within(2.01), 1U);
  EXPECT_EQ(exits_within(1.99), 0U);
}

TEST(Exits, DoorOfAWallThatWasNotSeenLatelyIsNone) {
  const auto exits_when_unseen_for = [](std::int64_t unseen_us) {
    Map map = room_with_doorway();
    for (Object& wall : map.objects) wall.last_seen = kNow;
    map.objects[1].last_seen = kNow - unseen_us;  // the wall left of the door
    return exits_of(map).size();
  };
  EXPECT_EQ(exits_when_unseen_for(2'400'000), 1U);
  EXPECT_EQ(exits_when_unseen_for(2'600'000), 0U);
}

TEST(Exits, DoorRoundACornerIsNone) {
  Map map = room_with_doorway();
  draw(map, {{0.6, 1}, {-0.6, 1}});
  EXPECT_TRUE(exits_of(map).empty());
  EXPECT_EQ(exits_of(map, {2, 0}).size(), 1U) << "from where the wall is not in between";
}

TEST(Exits, DoorSeenThroughAnotherIsNone) {
  Map map = room_with_doorway();
  const double y = 4.0;  // across a corridor
  draw(map, {{3, y}, {0.45, y}, {0.45, y + 0.2}});
  draw(map, {{-0.45, y + 0.2}, {-0.45, y}, {-3, y}});
  const auto exits = exits_of(map);
  ASSERT_EQ(exits.size(), 1U);
  EXPECT_NEAR(distance(exits[0].middle, {0, 2}), 0.0, kExact);
}

TEST(Exits, DoorSeenThroughAPossibleDoorIsNone) {
  Map map = loose_walls(0.9);
  const double y = 4.0;
  draw(map, {{3, y}, {0.45, y}, {0.45, y + 0.2}});
  draw(map, {{-0.45, y + 0.2}, {-0.45, y}, {-3, y}});
  ASSERT_EQ(openings_of(map).size(), 2U);
  EXPECT_TRUE(exits_of(map).empty());
  EXPECT_EQ(exits_of(map, {0, 3}).size(), 1U) << "from the corridor in between";
}

TEST(Exits, PossibleDoorBecomesOneWhereBothWallsAreSeenToEnd) {
  Map map = loose_walls(0.9);
  ASSERT_EQ(openings_of(map).size(), 1U);
  EXPECT_TRUE(exits_of(map).empty());
  end_point(map, 0, 1).method = CornerMethod::vector;
  ASSERT_EQ(openings_of(map).at(0).type, ObjectType::possible_door);
  EXPECT_TRUE(exits_of(map).empty()) << "one may go on";
  end_point(map, 1, 0).method = CornerMethod::vector;
  ASSERT_EQ(openings_of(map).at(0).type, ObjectType::door);
  EXPECT_EQ(exits_of(map).size(), 1U);
}

TEST(Exits, PossibleDoorOntoTheFaceOfAWallIsNone) {
  Map map;
  draw(map, {{3, 1}, {3, 3}});
  draw(map, {{2.1, 2}, {0, 2}});
  end_point(map, 1, 0).method = CornerMethod::vector;
  ASSERT_EQ(openings_of(map).size(), 1U);
  EXPECT_TRUE(exits_of(map).empty());
}

TEST(Exits, ExitSeenFromAnotherFrameIsTurnedAndMoved) {
  const Exit exit{.middle = {1, 0}, .direction = 3.0, .width = 0.9, .confidence = 0.7};
  const Exit moved = transform(Position{2, 3, kUp}, exit);
  EXPECT_NEAR(distance(moved.middle, {2, 4}), 0.0, kExact);
  EXPECT_NEAR(moved.direction, 3.0 + kUp - 2.0 * std::numbers::pi, kExact);
  EXPECT_EQ(moved.width, 0.9);
  EXPECT_EQ(moved.confidence, 0.7);
}

}  // namespace
}  // namespace perceptor::identify::test
