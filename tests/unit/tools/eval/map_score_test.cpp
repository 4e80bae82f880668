#include "tools/eval/map_score.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <pico/laser_scan_t.hpp>
#include <pico/map_t.hpp>
#include <pico/truth_t.hpp>

#include "common/bus/bus.hpp"
#include "common/bus/channels.hpp"
#include "common/messages/convert.hpp"
#include "common/time/stamp.hpp"
#include "tests/unit/tools/eval/true_room.hpp"
#include "tests/unit/tools/eval/walls.hpp"

namespace perceptor {
namespace {

constexpr std::int64_t kFirst = 10'000'000;
constexpr std::int64_t kPeriod = 100'000;
constexpr std::int64_t kScans = 40;  // four seconds

template <class Message>
LogEvent event(const char* channel, Message message, std::int64_t seq) {
  set_stamp(message, {kFirst + seq * kPeriod, 7, seq});
  return {0, 0, channel, messages::encode(message)};
}

/// A standing robot in the left room, two metres before the doorway, that looks all around.
class MapScoreTest : public ::testing::Test {
 protected:
  /// The walls of the left room, counter-clockwise: free space on their left.
  Map left_room() const {
    Map map;
    const TrueWorld world = testing::true_rooms(world_);
    for (const std::size_t side : {testing::kBelow, testing::kRightLower, testing::kRightUpper,
                                   testing::kAbove, testing::kLeft})
      testing::add_wall(map, world.sides[side].segment);
    return map;
  }

  /// The same map [world frame] with every scan, from the given one on; before that, none of its
  /// doors.
  MapScore score(const Map& map, std::int64_t doors_from = 0) const {
    MapScorer scorer;
    scorer.take(laser());
    scorer.take(event(channel::world, make_map_message("world", world_), 0));
    const Map in_robot = transform(map, inverse(robot_in_world_));
    for (std::int64_t seq = 0; seq < kScans; ++seq) {
      pico::truth_t truth{};
      truth.robot_in_world = to_message(robot_in_world_);
      scorer.take(event(channel::truth, truth, seq));
      Map now = in_robot;
      if (seq < doors_from)
        for (Object& object : now.objects) object.remove = object.type == ObjectType::door;
      remove_objects(now);
      const pico::map_t message = make_map_message("robot", now);
      scorer.take(event(channel::local_map, message, seq));
      scorer.take(event(channel::identified_map, message, seq));
    }
    return scorer.score();
  }

  LogEvent laser() const {
    pico::laser_scan_t scan{};
    scan.angle_min = -testing::kTurn / 2.0;
    scan.angle_max = testing::kTurn / 2.0;
    scan.angle_increment = testing::kTurn / (testing::kBeams - 1.0);
    scan.valid_min = 0.01;
    scan.valid_max = reach_;
    scan.range_sigma = 0.01;
    scan.num_ranges = static_cast<std::int32_t>(testing::kBeams);
    scan.ranges.assign(testing::kBeams, 1.0F);
    return event(channel::laser, scan, 0);
  }

  Map world_ = testing::two_rooms();
  Position robot_in_world_{2.0, 1.5, 0.7};
  double reach_ = 3.0;  // [m] the other room is farther away
};

TEST_F(MapScoreTest, AMapOfAllThatIsSeenIsWithoutFault) {
  const MapScore result = score(left_room());
  EXPECT_EQ(result.maps, 4);  // at 2.0, 2.5, 3.0 and 3.5 s
  EXPECT_EQ(result.walls.part, 4 * 5);
  EXPECT_EQ(result.walls.whole, 4 * 5);
  EXPECT_EQ(result.right.part, result.right.whole);
  EXPECT_EQ(result.right.whole, 4 * 5);
  EXPECT_EQ(result.doubles, 0);
}

TEST_F(MapScoreTest, AWallThatIsNotInTheMapIsMissed) {
  Map map = left_room();
  map.objects[testing::kAbove].remove = true;
  remove_objects(map);
  const MapScore result = score(map);
  EXPECT_EQ(result.walls.part, 4 * 4);
  EXPECT_EQ(result.walls.whole, 4 * 5);
}

TEST_F(MapScoreTest, AWallIsFoundWhereTheMapHoldsSevenTenthsOfIt) {
  Map map = left_room();
  set_segment(map, testing::kAbove, {{4.0, 3.0}, {1.0, 3.0}});
  EXPECT_EQ(score(map).walls.part, 4 * 5);
  set_segment(map, testing::kAbove, {{4.0, 3.0}, {1.5, 3.0}});
  EXPECT_EQ(score(map).walls.part, 4 * 4);
}

TEST_F(MapScoreTest, AWallThatWasSeenFromItsOtherSideIsNotTheOne) {
  Map map = left_room();
  map.objects[testing::kAbove].free_side = FreeSide::right;
  EXPECT_EQ(score(map).walls.part, 4 * 4);
}

TEST_F(MapScoreTest, AWallBesideTheTrueOneIsNeitherRightNorFound) {
  Map map = left_room();
  set_segment(map, testing::kAbove, {{4.0, 2.85}, {0.0, 2.85}});
  const MapScore result = score(map);
  EXPECT_EQ(result.walls.part, 4 * 4);
  EXPECT_EQ(result.right.part, 4 * 4);
}

TEST_F(MapScoreTest, TwoWallsForOneAreADouble) {
  Map map = left_room();
  testing::add_wall(map, {{3.0, 2.92}, {1.0, 2.92}});
  EXPECT_EQ(score(map).doubles, 4);
}

TEST_F(MapScoreTest, ASideOfFurnitureIsAskedForApart) {
  testing::add_object(world_, {{0.5, 1.0}, {0.5, 2.0}}, ObjectType::static_obstacle, 90);
  const MapScore result = score(left_room());
  EXPECT_EQ(result.furniture.part, 0);
  EXPECT_EQ(result.furniture.whole, 4);
}

TEST_F(MapScoreTest, ACornerIsMeasuredAgainstTheTrueOne) {
  Map map = left_room();
  const Index end = map.objects[testing::kBelow].points[1];
  const Index begin = map.objects[testing::kRightLower].points[0];
  connect(map, end, begin);
  for (const Index point : {end, begin}) {
    Point& corner = map.points[static_cast<std::size_t>(point)];
    corner.property = PointProperty::concave;
    corner.location += Vector2(0.03, 0.04);
  }
  const MapScore right = score(map);
  EXPECT_EQ(right.corners.right.whole, 4);
  EXPECT_EQ(right.corners.right.part, 4);
  EXPECT_NEAR(right.corners.rms(), 0.05, 1e-6);
  EXPECT_EQ(right.corners.confused.part, 0);
  EXPECT_EQ(right.corners.confused.whole, 4);

  for (const Index point : {end, begin})
    map.points[static_cast<std::size_t>(point)].property = PointProperty::convex;
  EXPECT_EQ(score(map).corners.confused.part, 4);
}

TEST_F(MapScoreTest, ADoorOnEitherFaceOfTheWallIsRight) {
  for (const double x : {4.0, 4.2}) {
    Map map = left_room();
    add_segment(map, {{x, 1.02}, {x, 1.99}}, ObjectType::door);
    const MapScore result = score(map);
    EXPECT_EQ(result.doors.right.part, 4);
    EXPECT_EQ(result.doors.right.whole, 4);
    EXPECT_EQ(result.doors.found.part, 1);
    EXPECT_EQ(result.doors.standing.part, result.doors.standing.whole);
  }
}

TEST_F(MapScoreTest, ADoorOfTheWrongWidthIsWrongAndTheOpeningMissed) {
  Map map = left_room();
  add_segment(map, {{4.0, 1.0}, {4.0, 1.88}}, ObjectType::door);
  const MapScore result = score(map);
  EXPECT_EQ(result.doors.right.part, 0);
  EXPECT_EQ(result.doors.right.whole, 4);
  EXPECT_EQ(result.doors.found.part, 0);
  EXPECT_EQ(result.doors.found.whole, 1);
}

TEST_F(MapScoreTest, TheDelayRunsFromTheScanThatShowsAllOfTheDoorway) {
  Map map = left_room();
  add_segment(map, {{4.0, 1.0}, {4.0, 2.0}}, ObjectType::door);
  const MapScore result = score(map, 6);
  ASSERT_EQ(result.doors.delays.size(), 1U);
  EXPECT_NEAR(result.doors.delays[0], 0.6, 1e-9);
}

TEST_F(MapScoreTest, GapsBesideFurnitureCountNeitherWay) {
  testing::add_object(world_, {{3.7, 0.85}, {3.85, 0.85}}, ObjectType::static_obstacle, 90);
  Map map = left_room();
  add_segment(map, {{4.0, 1.0}, {4.0, 2.0}}, ObjectType::door);
  const MapScore result = score(map);
  EXPECT_EQ(result.doors.right.whole, 0);
  EXPECT_EQ(result.doors.found.whole, 0);
}

TEST_F(MapScoreTest, ADoorFartherAwayThanThreeMetresCountsNeitherWay) {
  robot_in_world_ = {0.8, 1.5, 0.0};
  reach_ = 8.0;
  Map map = left_room();
  add_segment(map, {{4.0, 1.0}, {4.0, 2.0}}, ObjectType::door);
  const MapScore result = score(map);
  EXPECT_EQ(result.doors.right.whole, 0);
  EXPECT_EQ(result.doors.found.whole, 0);
}

TEST_F(MapScoreTest, AShutDoorIsNoOpeningToFind) {
  world_ = testing::two_rooms("shut");
  const MapScore result = score(left_room());
  EXPECT_EQ(result.doors.found.whole, 0);
  EXPECT_EQ(result.walls.whole, 4 * 5);
}

TEST(MapScorer, ALogWithoutTruthHasNoScore) {
  MapScorer scorer;
  scorer.take(event(channel::local_map, make_map_message("robot", {}), 0));
  EXPECT_EQ(scorer.score().maps, 0);
}

}  // namespace
}  // namespace perceptor
