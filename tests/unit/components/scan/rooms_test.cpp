// The default method in random rooms with exact truth, never used for tuning, at two noises and
// with the same parameters. Asked for is what the best published extractors are measured by.

#include <gtest/gtest.h>

#include "components/scan/extractor.hpp"
#include "tools/eval/extract.hpp"
#include "tools/eval/room_set.hpp"
#include "tools/eval/scan_score.hpp"

namespace perceptor::test {
namespace {

double percent(std::int64_t part, std::int64_t whole) {
  return 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

ScanScore score_of(const RoomScanParameters& parameters) {
  WallFinder finder(scan::ScanParameters{});
  ScanScorer scorer;
  for (const LabelledScan& labelled : make_room_scans(parameters).scans) {
    finder.run(labelled.scan);
    scorer.take(labelled, finder.found());
  }
  return scorer.score();
}

TEST(Rooms, AreSeenWithTheNoiseOfAGoodLaser) {
  RoomScanParameters parameters;
  parameters.scans = 210;
  parameters.seed = 2026;
  const ScanScore score = score_of(parameters);
  EXPECT_GE(percent(score.pieces_found, score.pieces), 99.3);
  EXPECT_LE(percent(score.false_walls, score.walls), 0.6);
  EXPECT_GE(percent(score.corners_found, score.corners), 98.7);
  EXPECT_LE(percent(score.false_corners, score.corner_claims), 1.0);
  EXPECT_EQ(score.corner_mix_ups, 0);
}

TEST(Rooms, AreSeenThroughThreeTimesTheNoiseWithOutliersAndDropouts) {
  RoomScanParameters parameters;
  parameters.scans = 210;
  parameters.seed = 2027;
  parameters.laser.sigma = 0.03;
  parameters.laser.outliers = 0.01;
  parameters.laser.dropouts = 0.01;
  const ScanScore score = score_of(parameters);
  EXPECT_GE(percent(score.pieces_found, score.pieces), 97.0);
  EXPECT_LE(percent(score.false_walls, score.walls), 4.0);
}

}  // namespace
}  // namespace perceptor::test
