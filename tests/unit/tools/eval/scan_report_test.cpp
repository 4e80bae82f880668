#include "tools/eval/scan_report.hpp"

#include <gmock/gmock.h>

namespace perceptor {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

ScanEvaluation evaluation() {
  ScanEvaluation evaluation;
  evaluation.floor_us = {2.0, 2.0, 2.0};
  const FoundWalls found = {{{{1.0, 2.0}, {-3.0, 0.123456}}}, {{{1.0, 2.0}, true}}};
  evaluation.methods = {{"quick", {20.0, 30.0, 50.0}, {found, {}, {}}, {}}};
  return evaluation;
}

ScanSet three_scans() {
  ScanSet set;
  set.scans.resize(3);
  for (std::size_t i = 0; i < 3; ++i) set.scans[i].id = static_cast<std::int64_t>(10 + i);
  return set;
}

TEST(ScanReport, WithoutTruthTheTableHasTimesAndCounts) {
  EXPECT_EQ(scan_table(evaluation()),
            "method  median   p99      x  walls  corners\n"
            "            us    us  floor\n"
            "floor      2.0   2.0    1.0      -        -\n"
            "quick     30.0  30.0   15.0      1        1\n");
}

TEST(ScanReport, WithTruthTheTableHasScores) {
  ScanEvaluation scored = evaluation();
  ScanScore score;
  score.pieces = 8;
  score.pieces_found = 7;
  score.walls = 10;
  score.false_walls = 3;
  score.fragments = 2;
  score.angle_rms = 0.0174532925;
  score.offset_rms = 0.00234;
  score.end_median = 0.0056;
  score.corners = 4;
  score.corners_found = 3;
  score.corner_claims = 5;
  score.false_corners = 1;
  score.corner_matches = 4;
  score.corner_mix_ups = 1;
  score.corner_median = 0.00123;
  scored.bound = ScanScore();
  scored.methods[0].score = score;
  const std::string table = scan_table(scored);
  EXPECT_THAT(table, HasSubstr("quick     30.0  30.0   15.0  87.5  30.0  20.0  1.000   2.34    "
                               "75.0    20.0    25.0    1.23    5.6\n"));
  EXPECT_THAT(table, HasSubstr("\nbound        -     -      -     -     -     -      -      -  "));
}

TEST(ScanReport, DumpsWallsAndCorners) {
  EXPECT_EQ(scan_dump(three_scans(), evaluation()),
            "E 10 1.00000 2.00000 -3.00000 0.12346\n"
            "C 10 1.00000 2.00000 1\n");
}

TEST(ScanReport, TheDumpNamesEachOfSeveralMethods) {
  ScanEvaluation two = evaluation();
  two.methods.push_back(two.methods[0]);
  two.methods[1].name = "slow";
  two.methods[1].found[2] = {{}, {{{0.0, -0.5}, false}}};
  EXPECT_EQ(scan_dump(three_scans(), two),
            "# method quick\n"
            "E 10 1.00000 2.00000 -3.00000 0.12346\n"
            "C 10 1.00000 2.00000 1\n"
            "# method slow\n"
            "E 10 1.00000 2.00000 -3.00000 0.12346\n"
            "C 10 1.00000 2.00000 1\n"
            "C 12 0.00000 -0.50000 -1\n");
  EXPECT_THAT(scan_dump(three_scans(), evaluation()), Not(HasSubstr("#")));
}

}  // namespace
}  // namespace perceptor
