#include "components/merge/rivals.hpp"

#include <gtest/gtest.h>

#include "tests/unit/components/merge/scene.hpp"

namespace perceptor::merge {
namespace {

constexpr RivalParameters kParameters;
const Vector2 kLaser{2.0, 1.5};

Wall known_wall(std::int32_t id, const Segment& segment, bool confirmed = true) {
  Wall wall;
  wall.id = id;
  wall.segment = segment;
  wall.confirmed = confirmed;
  return wall;
}

std::vector<Contradiction> against(const Segment& wall, const Segment& seen, int support = 40) {
  return contradictions({known_wall(0, wall), known_wall(1, seen)}, {{1, seen, support}}, kLaser,
                        kParameters);
}

// Free space is below walls that run to smaller x.
const Segment kWall{{4.0, 3.0}, {0.0, 3.0}};

TEST(Rivals, WallSeenBehindAnotherContradictsThePieceInFront) {
  const auto found = against(kWall, {{2.5, 3.15}, {1.5, 3.15}});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].wall, 0U);
  EXPECT_EQ(found[0].rival, 1U);
  EXPECT_NEAR(found[0].piece.from, 1.5, 1e-12);
  EXPECT_NEAR(found[0].piece.to, 2.5, 1e-12);
}

TEST(Rivals, WallSeenBeforeAnotherContradictsThePieceBehind) {
  const auto found = against(kWall, {{1.0, 2.8}, {-1.0, 2.8}});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].piece.from, 3.0, 1e-12);
  EXPECT_NEAR(found[0].piece.to, 4.0, 1e-12);
}

TEST(Rivals, ThereIsRoomForTwoWallsFurtherApartSlantedOrEndToEnd) {
  EXPECT_TRUE(against(kWall, {{2.5, 3.31}, {1.5, 3.31}}).empty());
  EXPECT_TRUE(against(kWall, {{2.5, 3.3}, {1.5, 3.0}}).empty());
  EXPECT_TRUE(against(kWall, {{0.15, 3.1}, {-2.0, 3.1}}).empty());
}

TEST(Rivals, OppositeFacesAreNoRivals) {
  EXPECT_TRUE(against(kWall, {{1.5, 3.05}, {2.5, 3.05}}).empty());
}

TEST(Rivals, ThereIsRoomForWhatStandsBehindAWallWithABack) {
  // A box behind a thick wall, both free on the side of the laser, and the back of the wall.
  const std::vector<Wall> walls = {known_wall(0, {{2.5, 3.25}, {1.5, 3.25}}), known_wall(1, kWall),
                                   known_wall(2, {{1.0, 3.15}, {3.0, 3.15}})};
  const Observation of_wall{1, kWall, 40};
  const Observation of_box{0, walls[0].segment, 40};
  EXPECT_TRUE(contradictions(walls, {of_wall}, kLaser, kParameters).empty());
  EXPECT_EQ(contradictions(walls, {of_box}, kLaser, kParameters).size(), 1U)
      << "the wall is looked through";
  const Vector2 beside_the_wall{4.5, 3.4};
  EXPECT_TRUE(contradictions(walls, {of_box}, beside_the_wall, kParameters).empty());
}

TEST(Rivals, FewBeamsSayNothing) {
  EXPECT_FALSE(against(kWall, {{2.5, 3.15}, {1.5, 3.15}}, 5).empty());
  EXPECT_TRUE(against(kWall, {{2.5, 3.15}, {1.5, 3.15}}, 4).empty());
}

TEST(Rivals, BeamsLieAtEqualAngles) {
  // A long wall seen at a grazing angle; of 40 beams the far half has not one.
  const Segment grazed{{2.0, 1.4}, {22.0, 1.4}};
  EXPECT_TRUE(against({{12.0, 1.3}, {22.0, 1.3}}, grazed).empty());
  EXPECT_FALSE(against({{2.0, 1.3}, {3.0, 1.3}}, grazed).empty());
}

TEST(Rivals, PieceThatWasSeenAsWellIsNotContradicted) {
  const Segment rival{{2.5, 3.15}, {1.5, 3.15}};
  const std::vector<Wall> walls = {known_wall(3, kWall), known_wall(7, rival)};
  const Observation of_rival{7, rival, 40};
  EXPECT_TRUE(contradictions(walls, {of_rival, {3, kWall, 40}}, kLaser, kParameters).empty());
  const Segment left_part{{4.0, 3.0}, {2.0, 3.0}};
  const auto found = contradictions(walls, {of_rival, {3, left_part, 40}}, kLaser, kParameters);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].piece.from, 2.0, 1e-12);
  EXPECT_NEAR(found[0].piece.to, 2.5, 1e-12);
}

TEST(Rivals, SightingIsCutOffWhereAnotherWallStandsInItsWay) {
  // The wall is known up to x = 2.5; between 2.5 and 1.5 there is a recess.
  const std::vector<Wall> walls = {known_wall(0, {{4.0, 3.0}, {2.6, 3.0}}),
                                   known_wall(1, {{2.5, 3.15}, {1.5, 3.15}})};
  const std::vector<Line> lines = {line_of(walls[0].segment), line_of(walls[1].segment)};
  Wall sighted;
  sighted.segment = kWall;
  sighted.ends[kHead].method = CornerMethod::spike;
  const Wall clear = clear_of_rivals(sighted, 0, walls, lines, kParameters);
  EXPECT_NEAR(clear.segment.a.x(), 4.0, 1e-12);
  EXPECT_NEAR(clear.segment.b.x(), 2.5, 1e-12);
  EXPECT_FALSE(is_known(clear.ends[kHead]));

  std::vector<Wall> tentative = walls;
  tentative[1].confirmed = false;
  EXPECT_NEAR(clear_of_rivals(sighted, 0, tentative, lines, kParameters).segment.b.x(), 0.0, 1e-12);
}

TEST(Rivals, LongestFreePieceIsLeft) {
  const std::vector<Wall> walls = {known_wall(0, kWall, false),
                                   known_wall(1, {{2.0, 3.1}, {1.0, 3.1}})};
  const Interval free = free_piece(walls[0], walls, kParameters);
  EXPECT_NEAR(free.from, 0.0, 1e-12);
  EXPECT_NEAR(free.to, 2.0, 1e-12);
  const std::vector<Wall> covered = {walls[0], known_wall(1, {{5.0, 3.1}, {-1.0, 3.1}})};
  const Interval none = free_piece(covered[0], covered, kParameters);
  EXPECT_LE(none.to, none.from);
}

// Whole sessions: the robot stands at (2, 1.5) in a room of 4 m by 3 m.

std::vector<Drawn> room_with(const std::vector<Drawn>& far_side) {
  std::vector<Drawn> scene = {wall(0, 0, 4, 0), wall(4, 0, 4, 3), wall(0, 3, 0, 0)};
  scene.insert(scene.end(), far_side.begin(), far_side.end());
  return scene;
}

/// Published walls that face down at x, by their y.
std::vector<double> far_side_at(const LocalMap& local, double x) {
  const Map map = in_local(local);
  std::vector<double> places;
  for (const Object& object : map.objects) {
    const Segment s = segment(map, object);
    if (s.b.x() < x && x < s.a.x()) places.push_back(distance(s, Vector2(x, 0.0)));
  }
  return places;
}

const std::vector<Drawn> kFlush = room_with({wall(4, 3, 0, 3)});
const std::vector<Drawn> kRecess = room_with(
    {wall(4, 3, 2.5, 3, CornerMethod::none, CornerMethod::spike), wall(2.5, 3.15, 1.5, 3.15),
     wall(1.5, 3, 0, 3, CornerMethod::spike, CornerMethod::none)});

TEST(Rivals, RecessIsCutOutOfTheWallThatItWasTakenFor) {
  Session session;
  session.see_often(kFlush, 40);
  LocalMap local;
  for (int i = 0; i < 12; ++i) {
    local = session.see(kRecess);
    EXPECT_EQ(far_side_at(local, 2.0).size(), 1U) << "never none, never two: scan " << i;
  }
  EXPECT_NEAR(far_side_at(local, 2.0).at(0), 3.15, 1e-3);
  EXPECT_NEAR(far_side_at(local, 3.0).at(0), 3.0, 1e-3);
  EXPECT_NEAR(far_side_at(local, 1.0).at(0), 3.0, 1e-3);
}

TEST(Rivals, WallSeenAtAGrazingAngleDoesNotCloseARecess) {
  Session session;
  session.see_often(kRecess, 40);
  Map grazing = draw(kFlush);
  grazing.objects.back().support = 8;
  for (int i = 0; i < 20; ++i) {
    const Position robot{2.0, 1.5, 0.3};
    const LocalMap local = session.take(transform(grazing, inverse(robot)), robot);
    ASSERT_EQ(far_side_at(local, 2.0).size(), 1U);
    EXPECT_NEAR(far_side_at(local, 2.0)[0], 3.15, 1e-3);
  }
}

TEST(Rivals, WhatStandsBeforeAWallForAMomentLeavesItWhole) {
  Session session;
  session.see_often(kFlush, 40);
  const std::vector<Drawn> legs =
      room_with({wall(4, 3, 2.3, 3), wall(2.2, 2.8, 1.8, 2.8), wall(1.7, 3, 0, 3)});
  session.see_often(legs, 2);
  const LocalMap local = session.see(kFlush);
  EXPECT_EQ(local.walls.objects.size(), 4U);
  EXPECT_NEAR(far_side_at(local, 2.0).at(0), 3.0, 1e-3);
}

TEST(Rivals, WhatIsPutBeforeAWallHidesIt) {
  Session session;
  session.see_often(kFlush, 40);
  const std::vector<Drawn> cupboard =
      room_with({wall(4, 3, 2.6, 3), wall(2.5, 2.8, 1.5, 2.8), wall(1.4, 3, 0, 3)});
  LocalMap local;
  for (int i = 0; i < 12; ++i) {
    local = session.see(cupboard);
    EXPECT_EQ(far_side_at(local, 2.0).size(), 1U);
  }
  EXPECT_NEAR(far_side_at(local, 2.0).at(0), 2.8, 1e-3);
}

}  // namespace
}  // namespace perceptor::merge
