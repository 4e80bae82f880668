#include "tools/eval/world_view.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/unit/tools/eval/true_room.hpp"

namespace perceptor {
namespace {

using testing::kBeams;
using testing::kTurn;

BeamFan all_around() { return {kBeams, -kTurn / 2.0, kTurn / (kBeams - 1.0), 8.0}; }

std::size_t beam_at(double bearing) {
  return static_cast<std::size_t>(std::lround((bearing + kTurn / 2.0) * (kBeams - 1.0) / kTurn));
}

TEST(CastBeams, ABeamEndsOnTheWallAheadOfIt) {
  const auto hits = cast_beams(testing::true_rooms(), {}, {1.0, 1.5, 0.0}, all_around());
  const BeamHit& back = hits[beam_at(std::numbers::pi)];
  EXPECT_EQ(back.side, testing::kLeft);
  EXPECT_NEAR(back.range, 1.0, 1e-9);
  EXPECT_NEAR(back.along, 1.5, 1e-9);
  EXPECT_EQ(hits[beam_at(-std::numbers::pi / 2.0)].side, testing::kBelow);
}

TEST(CastBeams, ABeamThroughTheDoorwayEndsInTheOtherRoom) {
  const auto hits = cast_beams(testing::true_rooms(), {}, {1.0, 1.5, 0.0}, all_around());
  EXPECT_NEAR(hits[beam_at(0.0)].range, 7.2, 1e-9);
}

TEST(CastBeams, WhatIsBeyondReachIsNotHit) {
  BeamFan fan = all_around();
  fan.reach = 7.0;
  const auto hits = cast_beams(testing::true_rooms(), {}, {1.0, 1.5, 0.0}, fan);
  EXPECT_EQ(hits[beam_at(0.0)].side, kNoSide);
}

TEST(CastBeams, TheHeadingOfTheLaserTurnsTheBeams) {
  const auto hits =
      cast_beams(testing::true_rooms(), {}, {1.0, 1.5, std::numbers::pi / 2.0}, all_around());
  EXPECT_EQ(hits[beam_at(0.0)].side, testing::kAbove);
  EXPECT_EQ(hits[beam_at(std::numbers::pi / 2.0)].side, testing::kLeft);
}

TEST(CastBeams, APersonHidesTheWallBehind) {
  const auto hits =
      cast_beams(testing::true_rooms(), {{{0.5, 1.5}, 0.25}}, {1.0, 1.5, 0.0}, all_around());
  EXPECT_EQ(hits[beam_at(std::numbers::pi)].side, kNoSide);
  EXPECT_EQ(hits[beam_at(std::numbers::pi - 0.7)].side, testing::kLeft);
}

TEST(SideViews, FromTheMiddleOfARoomItsWallsAreSeenWhole) {
  const TrueWorld world = testing::true_rooms();
  const auto hits = cast_beams(world, {}, {2.0, 1.5, 0.0}, all_around());
  const auto views = side_views(hits, world.sides.size(), 0.15);
  EXPECT_NEAR(views[testing::kBelow].seen(), 4.0, 0.1);
  EXPECT_NEAR(views[testing::kRightLower].seen(), 1.0, 0.1);
  EXPECT_NEAR(views[testing::kRightLower].distance_to(1.0), 0.0, 0.05);
}

TEST(SideViews, BeamsThatHitFarApartShowNothingBetweenThem) {
  const std::vector<BeamHit> hits = {{0, 0.0, 1.0}, {0, 0.1, 1.0}, {0, 0.5, 1.0}};
  const auto views = side_views(hits, 1, 0.15);
  EXPECT_EQ(views[0].beams, 3U);
  EXPECT_NEAR(views[0].seen(), 0.1, 1e-12);
  EXPECT_NEAR(views[0].distance_to(0.3), 0.2, 1e-12);
}

}  // namespace
}  // namespace perceptor
