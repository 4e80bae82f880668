#include "tools/eval/scan_score.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/unit/tools/eval/drawing.hpp"

namespace perceptor {
namespace {

using testing::along_x;
using testing::piece;

constexpr double kRounding = 1e-12;

/// Two walls of a room that meet at the origin, and a third that need not be found.
LabelledScan two_walls() {
  LabelledScan scan;
  scan.pieces = {piece(1, {{2.0, 0.0}, {0.0, 0.0}}), piece(2, {{0.0, 0.0}, {0.0, 2.0}}),
                 piece(3, along_x(5.0, 5.2, 5.0), false)};
  scan.corners = {{{0.0, 0.0}, false, true}, {{5.0, 5.0}, true, false}};
  return scan;
}

FoundWalls perfect() {
  const LabelledScan truth = two_walls();
  return {{truth.pieces[0].segment, truth.pieces[1].segment}, {{{0.0, 0.0}, false}}};
}

ScanScore score(const FoundWalls& found) {
  ScanScorer scorer;
  scorer.take(two_walls(), found);
  return scorer.score();
}

TEST(ScanScore, APerfectMatchHasNoErrors) {
  const ScanScore result = score(perfect());
  EXPECT_EQ(result.pieces, 2);
  EXPECT_EQ(result.pieces_found, 2);
  EXPECT_EQ(result.walls, 2);
  EXPECT_EQ(result.false_walls, 0);
  EXPECT_NEAR(result.angle_rms, 0.0, kRounding);
  EXPECT_NEAR(result.offset_rms, 0.0, kRounding);
  EXPECT_NEAR(result.end_median, 0.0, kRounding);
  EXPECT_EQ(result.corners, 1);
  EXPECT_EQ(result.corners_found, 1);
  EXPECT_EQ(result.false_corners, 0);
  EXPECT_EQ(result.corner_mix_ups, 0);
}

TEST(ScanScore, NothingFoundIsNothingWrong) {
  const ScanScore result = score({});
  EXPECT_EQ(result.pieces, 2);
  EXPECT_EQ(result.pieces_found, 0);
  EXPECT_EQ(result.walls, 0);
  EXPECT_EQ(result.corners_found, 0);
  EXPECT_EQ(result.angle_rms, 0.0);
  EXPECT_EQ(result.corner_median, 0.0);
}

TEST(ScanScore, FragmentsAndWallsOnNothingAreFalse) {
  FoundWalls found = perfect();
  found.walls.push_back(along_x(0.1, 0.5, 0.01));
  found.walls.push_back(along_x(8.0, 9.0));
  const ScanScore result = score(found);
  EXPECT_EQ(result.pieces_found, 2);
  EXPECT_EQ(result.walls, 4);
  EXPECT_EQ(result.false_walls, 2);
  EXPECT_EQ(result.fragments, 1);
}

TEST(ScanScore, NeutralWallsAreNotAmongTheWalls) {
  FoundWalls found = perfect();
  found.walls.push_back(along_x(5.0, 5.2, 5.0));
  const ScanScore result = score(found);
  EXPECT_EQ(result.walls, 2);
  EXPECT_EQ(result.false_walls, 0);
}

TEST(ScanScore, ErrorsAreTakenAtThePiecesMiddle) {
  // Turned about (0, 0) by 0.01 rad: at the middle of the piece, 1 m on, that is 0.01 m.
  const ScanScore result =
      score({{{{0.0, 0.0}, {2.0 * std::cos(0.01), 2.0 * std::sin(0.01)}}}, {}});
  EXPECT_EQ(result.pieces_found, 1);
  EXPECT_NEAR(result.angle_rms, 0.01, kRounding);
  EXPECT_NEAR(result.offset_rms, std::sin(0.01), kRounding);
}

TEST(ScanScore, EndsAreComparedInTheWallsOwnDirection) {
  const ScanScore result = score({{along_x(0.03, 1.97)}, {}});
  EXPECT_NEAR(result.end_median, 0.03, kRounding);
}

TEST(ScanScore, AWallOverTwoPiecesEndsWhereTheOuterOnesDo) {
  LabelledScan truth;
  truth.pieces = {piece(1, along_x(1.2, 2.2)), piece(1, along_x(0.0, 1.0))};
  ScanScorer scorer;
  scorer.take(truth, {{along_x(0.02, 2.18)}, {}});
  EXPECT_EQ(scorer.score().pieces_found, 2);
  EXPECT_NEAR(scorer.score().end_median, 0.02, kRounding);
}

TEST(ScanScore, TellsConvexCornersTakenForConcave) {
  FoundWalls found = perfect();
  found.corners[0] = {{0.1, 0.0}, true};
  const ScanScore result = score(found);
  EXPECT_EQ(result.corners_found, 1);
  EXPECT_EQ(result.corner_matches, 1);
  EXPECT_EQ(result.corner_mix_ups, 1);
  EXPECT_NEAR(result.corner_median, 0.1, kRounding);
}

TEST(ScanScore, ACornerFarFromAnyAndASecondAtOneAreFalse) {
  FoundWalls found = perfect();
  found.corners = {{{0.05, 0.0}, false}, {{0.0, 0.01}, false}, {{0.16, 0.0}, false}};
  const ScanScore result = score(found);
  EXPECT_EQ(result.corner_claims, 3);
  EXPECT_EQ(result.corners_found, 1);
  EXPECT_EQ(result.false_corners, 2);
  EXPECT_NEAR(result.corner_median, 0.01, kRounding);
}

TEST(ScanScore, ACornerThatNeedNotBeFoundIsNotFalse) {
  FoundWalls found = perfect();
  found.corners.push_back({{5.0, 5.1}, true});
  const ScanScore result = score(found);
  EXPECT_EQ(result.corners, 1);
  EXPECT_EQ(result.corners_found, 1);
  EXPECT_EQ(result.false_corners, 0);
}

TEST(ScanScore, AddsUpOverScans) {
  ScanScorer scorer;
  scorer.take(two_walls(), perfect());
  scorer.take(two_walls(), {{along_x(0.0, 2.0, 0.02)}, {}});
  const ScanScore result = scorer.score();
  EXPECT_EQ(result.pieces, 4);
  EXPECT_EQ(result.pieces_found, 3);
  EXPECT_NEAR(result.offset_rms, 0.02 / std::sqrt(3.0), kRounding);
}

}  // namespace
}  // namespace perceptor
