#include "components/identify/openings.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/unit/components/identify/scene.hpp"

namespace perceptor::identify::test {
namespace {

/// Places are copied from the walls' ends, never computed.
constexpr double kExact = 1e-9;

constexpr std::size_t kTail = 0;
constexpr std::size_t kHead = 1;

void expect_one(const std::vector<Opening>& openings, ObjectType type, std::string_view reason) {
  ASSERT_EQ(openings.size(), 1U);
  EXPECT_EQ(openings[0].type, type);
  EXPECT_EQ(openings[0].reason, reason);
  EXPECT_GT(openings[0].confidence, 0.0);
  EXPECT_LE(openings[0].confidence, 1.0);
}

TEST(Doors, DoorwayInAWallIsOneDoorBetweenItsCorners) {
  const auto openings = openings_of(doorway(0.9));
  expect_one(openings, ObjectType::door, "two convex corners");
  const Opening& door = openings[0];
  EXPECT_NEAR(width_of(door), 0.9, kExact);
  EXPECT_NEAR(distance(middle_of(door), {0, 2}), 0.0, kExact);
  EXPECT_NEAR(door.confidence, 1.0, kExact);
  // The free side, where the robot is, lies left of the way from first to second.
  EXPECT_EQ(door.free_side, FreeSide::left);
  EXPECT_NEAR(distance(door.first.location, {0.45, 2}), 0.0, kExact);
  EXPECT_NEAR(distance(door.second.location, {-0.45, 2}), 0.0, kExact);
}

TEST(Doors, WidthDecidesAtBothLimits) {
  EXPECT_TRUE(openings_of(doorway(0.44)).empty());
  EXPECT_EQ(openings_of(doorway(0.48)).size(), 1U);
  EXPECT_EQ(openings_of(doorway(1.52)).size(), 1U);
  EXPECT_TRUE(openings_of(doorway(1.56)).empty());
}

TEST(Doors, ConfidenceFallsWithAngleOffsetAndUnusualWidth) {
  const double usual = openings_of(doorway(0.9)).at(0).confidence;
  EXPECT_LT(openings_of(doorway(0.55)).at(0).confidence, usual);
  EXPECT_LT(openings_of(doorway(1.45)).at(0).confidence, usual);
  Map displaced = doorway(0.9);
  for (const Index wall : {2, 3}) {
    for (const std::size_t end : {kTail, kHead})
      end_point(displaced, wall, end).location.y() += 0.1;
  }
  EXPECT_LT(openings_of(displaced).at(0).confidence, usual);
}

TEST(Doors, WallsOutOfLineAreNoDoor) {
  Map displaced = doorway(0.9);
  for (const Index wall : {2, 3}) {
    for (const std::size_t end : {kTail, kHead})
      end_point(displaced, wall, end).location.y() += 0.3;
  }
  EXPECT_TRUE(openings_of(displaced).empty());

  Map bent = doorway(0.9);  // by 0.35 rad
  end_point(bent, 3, kHead).location = {-3, 2.93};
  EXPECT_TRUE(openings_of(bent).empty());
}

TEST(Doors, WallsThatFaceOppositeWaysAreNoDoor) {
  Map map;
  draw(map, {{3, 2}, {0.45, 2}, {0.45, 2.2}});
  draw(map, {{-3, 2}, {-0.45, 2}, {-0.45, 1.8}});  // free on the far side
  EXPECT_TRUE(openings_of(map).empty());
}

TEST(Doors, UnknownFreeSideCostsConfidence) {
  Map map = loose_walls(0.9);
  const double known = openings_of(map).at(0).confidence;
  map.objects[0].free_side = FreeSide::unknown;
  EXPECT_NEAR(openings_of(map).at(0).confidence, 0.8 * known, kExact);
  EXPECT_EQ(openings_of(map).at(0).free_side, FreeSide::left);

  map.objects[1].free_side = FreeSide::unknown;
  const Opening opening = openings_of(map).at(0);
  EXPECT_EQ(opening.free_side, FreeSide::unknown);
  const Vector2 across = opening.second.location - opening.first.location;
  EXPECT_GT(cross(across, kRobot - opening.first.location), 0.0);
}

TEST(Doors, ShortWallsBoundNothing) {
  Map map;
  draw(map, {{0.6, 2}, {0.45, 2}, {0.45, 2.2}});
  draw(map, {{-0.45, 2.2}, {-0.45, 2}, {-3, 2}});
  EXPECT_TRUE(openings_of(map).empty());
}

TEST(Doors, BothFacesOfAThickWallAreOneDoorOnTheRobotsSide) {
  Map map;
  draw(map, {{3, 2}, {0.45, 2}, {0.45, 2.2}, {3, 2.2}});
  draw(map, {{-3, 2.2}, {-0.45, 2.2}, {-0.45, 2}, {-3, 2}});
  const auto near = openings_of(map, {0, 0});
  expect_one(near, ObjectType::door, "two convex corners");
  EXPECT_NEAR(distance(middle_of(near[0]), {0, 2}), 0.0, kExact);
  const auto far = openings_of(map, {1, 4});
  expect_one(far, ObjectType::door, "two convex corners");
  EXPECT_NEAR(distance(middle_of(far[0]), {0, 2.2}), 0.0, kExact);
}

TEST(Doors, WallAcrossTheOpeningShutsIt) {
  const auto shut_by = [](const Vector2& a, const Vector2& b) {
    Map map = doorway(0.9);
    draw(map, {a, b});
    return openings_of(map).empty();
  };
  EXPECT_TRUE(shut_by({0.45, 2}, {-0.45, 2})) << "flush";
  EXPECT_TRUE(shut_by({0.45, 2.1}, {-0.45, 2.1})) << "a door that stands back";
  EXPECT_TRUE(shut_by({0.5, 1.95}, {-0.5, 1.95})) << "a board before it";
  EXPECT_TRUE(shut_by({0, 1}, {0.1, 3})) << "a wall right through";
  EXPECT_TRUE(shut_by({0.1, 2}, {0.1, 2.5})) << "a wall that begins in it";
  EXPECT_TRUE(shut_by({0.44, 1}, {0.46, 3})) << "through its edge";
  EXPECT_TRUE(shut_by({0.45, 2}, {0, 2.6})) << "a leaf half open";
  EXPECT_FALSE(shut_by({0.42, 2}, {0.35, 2.8})) << "a leaf that is open";
  EXPECT_FALSE(shut_by({3, 3}, {-3, 3})) << "the corridor's wall";
  EXPECT_FALSE(shut_by({0.43, 2.01}, {0.43, 2.3})) << "a doubled jamb";
  EXPECT_FALSE(shut_by({0.6, 2.1}, {2.0, 2.1})) << "beside it";
}

TEST(Doors, NicheIsNoDoor) {
  Map map;
  draw(map, {{3, 2}, {0.45, 2}, {0.45, 2.3}, {-0.45, 2.3}, {-0.45, 2}, {-3, 2}});
  EXPECT_TRUE(openings_of(map).empty());
}

TEST(Doors, TwoDoorwaysWithAPillarBetweenUseEachCornerOnce) {
  Map map;
  draw(map, {{4, 2}, {1.05, 2}, {1.05, 2.2}});
  draw(map, {{0.15, 2.2}, {0.15, 2}, {-0.15, 2}, {-0.15, 2.2}});
  draw(map, {{-1.05, 2.2}, {-1.05, 2}, {-4, 2}});
  const auto openings = openings_of(map);
  ASSERT_EQ(openings.size(), 2U);
  for (const Opening& door : openings) {
    EXPECT_EQ(door.type, ObjectType::door);
    EXPECT_NEAR(width_of(door), 0.9, kExact);
    EXPECT_NEAR(std::abs(middle_of(door).x()), 0.6, kExact);
  }
  EXPECT_NE(openings[0].first.point, openings[1].first.point);
}

TEST(Doors, ThreeDoorwaysInARowAreThreeDoors) {
  Map map;
  draw(map, {{5, 2}, {2, 2}, {2, 2.2}});
  draw(map, {{1.2, 2.2}, {1.2, 2}, {0.4, 2}, {0.4, 2.2}});
  draw(map, {{-0.4, 2.2}, {-0.4, 2}, {-1.2, 2}, {-1.2, 2.2}});
  draw(map, {{-2, 2.2}, {-2, 2}, {-5, 2}});
  const auto openings = openings_of(map);
  ASSERT_EQ(openings.size(), 3U);
  for (const Opening& door : openings) EXPECT_NEAR(width_of(door), 0.8, kExact);
}

TEST(Doors, BetterPartnerWinsACornerThatTwoCouldUse) {
  // Two walls on the left whose corners both suit the right one: one in line, one 0.12 m off.
  Map map;
  draw(map, {{3, 2}, {0.45, 2}, {0.45, 2.2}});
  draw(map, {{-0.45, 2.2}, {-0.45, 2}, {-3, 2}});
  draw(map, {{-0.6, 1.7}, {-0.6, 1.88}, {-3, 1.88}}, FreeSide::unknown);
  const auto openings = openings_of(map);
  ASSERT_FALSE(openings.empty());
  EXPECT_EQ(openings[0].type, ObjectType::door);
  EXPECT_NEAR(width_of(openings[0]), 0.9, kExact);
  EXPECT_EQ(openings.size(), 1U);
}

TEST(Doors, MouthOfAnLShapedCorridorIsNone) {
  Map map;
  draw(map, {{5, -0.6}, {-1, -0.6}, {-1, 5}}, FreeSide::right);
  draw(map, {{5, 0.6}, {0.2, 0.6}, {0.2, 5}});
  EXPECT_TRUE(openings_of(map).empty());
}

TEST(Doors, CorridorBehindADoorwayMakesNone) {
  // The room with two concave corners before the robot, the doorway it stands in, and the
  // corridor's wall behind it, of which the robot sees two pieces.
  Map map;
  draw(map, {{-0.1, -2}, {0, -2}});
  draw(map, {{0, -0.4}, {0, -2}, {3, -2}, {3, 2}, {0, 2}, {0, 0.4}});
  end_point(map, 1, kTail).method = CornerMethod::spike;
  end_point(map, 5, kHead).method = CornerMethod::spike;
  draw(map, {{-1.5, 3}, {-1.5, 1.2}});
  draw(map, {{-1.5, -1.2}, {-1.5, -3}});
  const auto openings = openings_of(map);
  expect_one(openings, ObjectType::door, "two outer ends");
  EXPECT_NEAR(width_of(openings[0]), 0.8, kExact);
}

TEST(Doors, OuterEndsMakeADoorOfLessConfidence) {
  Map map = loose_walls(0.9);
  end_point(map, 0, kHead).method = CornerMethod::spike;
  end_point(map, 1, kTail).method = CornerMethod::spike;
  const auto openings = openings_of(map);
  expect_one(openings, ObjectType::door, "two outer ends");
  EXPECT_NEAR(openings[0].confidence, 0.64, kExact);
}

TEST(Doors, TurnedEndIsTheJambAcrossFromAnother) {
  Map map = loose_walls(0.9);
  end_point(map, 0, kHead).method = CornerMethod::spike;
  end_point(map, 1, kTail).method = CornerMethod::vector;
  expect_one(openings_of(map), ObjectType::door, "outer end and turned end");
  end_point(map, 0, kHead).method = CornerMethod::intersection;
  expect_one(openings_of(map), ObjectType::door, "two turned ends");
}

/// Two walls 1 m long that face each other across a passage of 0.8 m, seen from within: both
/// end at x = 2, the right one `longer` further on; only jumps in range show that they end.
Map passage(double longer) {
  Map map;
  draw(map, {{1, -0.4}, {2 + longer, -0.4}});
  draw(map, {{2, 0.4}, {1, 0.4}});
  end_point(map, 0, kHead).method = CornerMethod::spike;
  end_point(map, 1, kTail).method = CornerMethod::spike;
  return map;
}

TEST(Doors, JambsThatFaceEachOtherAreADoorSeenFromWithin) {
  Map map = passage(0.1);
  draw(map, {{3.5, -2}, {3.5, 2}});  // the corridor's wall behind
  const auto openings = openings_of(map);
  expect_one(openings, ObjectType::door, "facing jambs that end");
  EXPECT_NEAR(width_of(openings[0]), std::hypot(0.8, 0.1), kExact);
  EXPECT_NEAR(distance(middle_of(openings[0]), {2.05, 0}), 0.0, kExact);
  const Vector2 across = openings[0].second.location - openings[0].first.location;
  EXPECT_GT(cross(across, kRobot - openings[0].first.location), 0.0) << "free side: within";
}

TEST(Doors, JambsHaveToEndTogetherFaceEachOtherAndStandOpen) {
  EXPECT_TRUE(openings_of(passage(0.4)).empty()) << "one goes on";

  Map back_to_back = passage(0.0);
  back_to_back.objects[0].free_side = FreeSide::right;
  back_to_back.objects[1].free_side = FreeSide::right;
  EXPECT_TRUE(openings_of(back_to_back).empty()) << "two sides of one block";

  Map shut = passage(0.0);
  draw(shut, {{2.2, -1}, {2.2, 1}});
  EXPECT_TRUE(openings_of(shut).empty()) << "a wall behind";

  Map funnel = passage(0.0);
  end_point(funnel, 1, kHead).location = {1, 0.75};
  EXPECT_TRUE(openings_of(funnel).empty()) << "not parallel";

  Map corridor = passage(0.0);
  end_point(corridor, 0, kTail).location.x() = 0.4;
  end_point(corridor, 1, kHead).location.x() = 0.4;
  EXPECT_TRUE(openings_of(corridor).empty()) << "a corridor that ends";

  Map loose = passage(0.0);
  end_point(loose, 0, kHead).method = CornerMethod::none;
  EXPECT_TRUE(openings_of(loose).empty()) << "one may go on unseen";
}

TEST(PossibleDoors, CornerAndLooseEnd) {
  Map map;
  draw(map, {{3, 2}, {0.45, 2}, {0.45, 2.2}});
  draw(map, {{-0.45, 2}, {-3, 2}});
  const auto openings = openings_of(map);
  expect_one(openings, ObjectType::possible_door, "convex corner and loose end");
  EXPECT_NEAR(width_of(openings[0]), 0.9, kExact);
}

TEST(PossibleDoors, TwoLooseEnds) {
  const auto openings = openings_of(loose_walls(0.9));
  expect_one(openings, ObjectType::possible_door, "two loose ends");
  EXPECT_NEAR(distance(middle_of(openings[0]), {0, 2}), 0.0, kExact);
}

TEST(PossibleDoors, ConcaveCornerFormsNone) {
  Map map;
  draw(map, {{3, 2}, {0.45, 2}, {0.45, 1}});  // free on the left: the inside of a room
  map.objects[0].free_side = FreeSide::left;
  map.objects[1].free_side = FreeSide::left;
  draw(map, {{-0.45, 2}, {-3, 2}});
  Map concave = map;
  EXPECT_TRUE(openings_of(concave).empty());
}

/// A wall along y = 2 that ends `width` before the inside of a wall along x = -1.
Map end_and_face(double width, FreeSide face) {
  Map map;
  draw(map, {{3, 2}, {-1 + width, 2}});
  draw(map, {{-1, 4}, {-1, 0}}, face);
  return map;
}

TEST(PossibleDoors, LooseEndThatFacesAWall) {
  const auto openings = openings_of(end_and_face(0.9, FreeSide::left));
  expect_one(openings, ObjectType::possible_door, "loose end faces wall");
  EXPECT_NEAR(distance(openings[0].first.location, {-0.1, 2}), 0.0, kExact);
  EXPECT_NEAR(distance(openings[0].second.location, {-1, 2}), 0.0, kExact);
  EXPECT_EQ(openings[0].second.point, kNone);
  EXPECT_EQ(openings[0].second.wall, 1);
}

TEST(PossibleDoors, FaceHasToBeNearSquareAndFreeTowardsTheEnd) {
  EXPECT_TRUE(openings_of(end_and_face(0.4, FreeSide::left)).empty()) << "too near";
  EXPECT_TRUE(openings_of(end_and_face(1.6, FreeSide::left)).empty()) << "too far";
  EXPECT_TRUE(openings_of(end_and_face(0.9, FreeSide::right)).empty()) << "its back";

  Map slanted = end_and_face(0.9, FreeSide::left);
  end_point(slanted, 1, kTail).location = {0, 4};
  end_point(slanted, 1, kHead).location = {-2, 0};
  EXPECT_TRUE(openings_of(slanted).empty()) << "not square";

  Map at_its_end = end_and_face(0.9, FreeSide::left);
  end_point(at_its_end, 1, kTail).location = {-1, 2.05};
  EXPECT_TRUE(openings_of(at_its_end).empty()) << "hits the end of the wall";

  Map passed = end_and_face(0.9, FreeSide::left);
  end_point(passed, 1, kTail).location = {-1, 1.5};
  EXPECT_TRUE(openings_of(passed).empty()) << "passes the wall by";

  Map hidden = end_and_face(0.9, FreeSide::left);
  draw(hidden, {{-0.5, 2.5}, {-0.5, 1.5}}, FreeSide::right);
  EXPECT_TRUE(openings_of(hidden).empty()) << "another wall stands before it";
}

TEST(PossibleDoors, OneThatOverlapsADoorIsLeftOut) {
  // The far face of the wall has been seen in part: two loose ends behind the door.
  Map map = doorway(0.9);
  draw(map, {{-3, 2.3}, {-0.5, 2.3}});
  draw(map, {{0.5, 2.3}, {3, 2.3}});
  expect_one(openings_of(map), ObjectType::door, "two convex corners");
}

TEST(PossibleDoors, OneThatCrossesADoorIsLeftOut) {
  // A loose end inside the room looks through the door at a wall of the corridor.
  Map map = doorway(0.9);
  draw(map, {{0, 0.5}, {0, 1.5}});
  draw(map, {{2, 2.8}, {-2, 2.8}});
  expect_one(openings_of(map), ObjectType::door, "two convex corners");
}

TEST(PossibleDoors, JambsDoNotPointAcrossTheCorridor) {
  // Two doorways opposite each other, 0.8 m of corridor between the far ends of their jambs.
  Map map = doorway(0.9);
  draw(map, {{-3, 3.2}, {-0.45, 3.2}, {-0.45, 3}});
  draw(map, {{0.45, 3}, {0.45, 3.2}, {3, 3.2}});
  const auto openings = openings_of(map);
  ASSERT_EQ(openings.size(), 2U);
  for (const Opening& opening : openings) {
    EXPECT_EQ(opening.reason, "two convex corners");
    EXPECT_NEAR(middle_of(opening).x(), 0.0, kExact);
  }
  // And one that looks at the corridor's other wall.
  Map narrow = doorway(0.9);
  draw(narrow, {{3, 2.9}, {-3, 2.9}});
  expect_one(openings_of(narrow), ObjectType::door, "two convex corners");
}

TEST(PossibleDoors, TwoGuessesAtOneGapAreOne) {
  Map map = loose_walls(0.9);
  draw(map, {{3, 2.25}, {0.4, 2.25}});
  draw(map, {{-0.4, 2.25}, {-3, 2.25}});
  EXPECT_EQ(openings_of(map).size(), 1U);
}

}  // namespace
}  // namespace perceptor::identify::test
