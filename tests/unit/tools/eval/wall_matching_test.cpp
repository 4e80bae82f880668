#include "tools/eval/wall_matching.hpp"

#include <cmath>

#include <gmock/gmock.h>

#include "tests/unit/tools/eval/drawing.hpp"

namespace perceptor {
namespace {

using testing::along_x;
using ::testing::ElementsAre;
using ::testing::Eq;
using ::testing::Optional;
using testing::piece;

using enum WallVerdict;

WallMatching match(const std::vector<TruePiece>& pieces, const std::vector<Segment>& walls) {
  return match_walls(pieces, walls, {});
}

/// Of one wall, where the truth is from 0 to 1 along x.
WallVerdict verdict(const Segment& wall) {
  return match({piece(1, along_x(0.0, 1.0))}, {wall}).verdicts.front();
}

TEST(WallMatching, AWallMatchesItsPieceWhicheverWayItRuns) {
  EXPECT_EQ(verdict(along_x(0.0, 1.0)), matched);
  EXPECT_EQ(verdict(along_x(1.0, 0.0)), matched);
}

TEST(WallMatching, AngleAndOffsetAreLimited) {
  const double four_degrees = std::tan(0.0698);
  const double six_degrees = std::tan(0.1047);
  EXPECT_EQ(verdict({{0.0, 0.0}, {1.0, four_degrees}}), matched);
  EXPECT_EQ(verdict({{0.0, 0.0}, {1.0, six_degrees}}), nothing);
  EXPECT_EQ(verdict(along_x(0.0, 1.0, 0.09)), matched);
  EXPECT_EQ(verdict(along_x(0.0, 1.0, -0.11)), nothing);
}

TEST(WallMatching, HalfOfThePieceAndHalfOfTheWallOverlap) {
  EXPECT_EQ(verdict(along_x(0.0, 0.51)), matched);
  EXPECT_EQ(verdict(along_x(0.0, 0.49)), fragment);
  EXPECT_EQ(verdict(along_x(0.0, 1.99)), matched);
  EXPECT_EQ(verdict(along_x(0.0, 2.01)), nothing);
}

TEST(WallMatching, OfABrokenWallTheLongerPartMatchesAndTheRestIsAFragment) {
  const WallMatching matching =
      match({piece(1, along_x(0.0, 2.0))}, {along_x(1.2, 2.0), along_x(0.0, 1.2)});
  EXPECT_THAT(matching.verdicts, ElementsAre(fragment, matched));
  EXPECT_THAT(matching.wall_of_pieces, ElementsAre(Optional(Eq(1U))));
}

TEST(WallMatching, ASecondWallOnTheSamePieceIsAFragment) {
  EXPECT_THAT(
      match({piece(1, along_x(0.0, 1.0))}, {along_x(0.0, 0.9, 0.05), along_x(0.0, 1.0)}).verdicts,
      ElementsAre(fragment, matched));
}

TEST(WallMatching, AWallOnNothingIsNothing) {
  EXPECT_THAT(
      match({piece(1, along_x(0.0, 1.0))}, {along_x(3.0, 4.0), {{0.5, 0.0}, {0.5, 1.0}}}).verdicts,
      ElementsAre(nothing, nothing));
  EXPECT_THAT(match({}, {along_x(0.0, 1.0)}).verdicts, ElementsAre(nothing));
  EXPECT_THAT(match({piece(1, along_x(0.0, 1.0))}, {along_x(0.5, 0.5)}).verdicts,
              ElementsAre(nothing));
}

TEST(WallMatching, WhatNeedNotBeFoundCountsNeitherWay) {
  const std::vector<TruePiece> pieces = {piece(1, along_x(0.0, 0.2), false)};
  EXPECT_THAT(match(pieces, {along_x(0.0, 0.2)}).verdicts, ElementsAre(neutral));
  EXPECT_THAT(match(pieces, {along_x(0.0, 0.12), along_x(0.13, 0.2)}).verdicts,
              ElementsAre(neutral, neutral));
}

TEST(WallMatching, OneWallMayCoverSeveralPiecesOfOneEdge) {
  // A table leg hides the middle; of either piece alone the wall is more than twice as long.
  const std::vector<TruePiece> pieces = {piece(1, along_x(0.0, 1.0)), piece(1, along_x(1.2, 2.2))};
  const WallMatching matching = match(pieces, {along_x(-0.1, 2.3)});
  EXPECT_THAT(matching.verdicts, ElementsAre(matched));
  EXPECT_THAT(matching.wall_of_pieces, ElementsAre(Optional(Eq(0U)), Optional(Eq(0U))));
}

TEST(WallMatching, OneWallCoversPiecesOfOneEdgeOnly) {
  const std::vector<TruePiece> pieces = {piece(1, along_x(0.0, 1.0)), piece(2, along_x(1.1, 2.0))};
  const WallMatching matching = match(pieces, {along_x(0.0, 2.0)});
  EXPECT_THAT(matching.verdicts, ElementsAre(matched));
  EXPECT_THAT(matching.wall_of_pieces, ElementsAre(Optional(Eq(0U)), Eq(std::nullopt)));
}

}  // namespace
}  // namespace perceptor
