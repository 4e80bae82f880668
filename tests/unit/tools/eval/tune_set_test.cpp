/// @file The bound on the recorded tuning set, as published with it: this calibrates how the
/// rules of scoring are read. Tolerances are the last digit published.
#include <numbers>

#include <gtest/gtest.h>

#include "tests/support/recorded_data.hpp"
#include "tools/eval/scan_score.hpp"
#include "tools/eval/scan_set_reader.hpp"
#include "tools/eval/true_association.hpp"

namespace perceptor {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

double percent(std::int64_t part, std::int64_t whole) {
  return 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

TEST(TuneSet, TheBoundIsAsPublished) {
  PERCEPTOR_REQUIRE_RECORDED("segments/tune.scan.gz");
  const auto scans = *testing::recorded("segments/tune.scan.gz");
  ScanSet set = read_scans(scans);
  ASSERT_TRUE(default_truth_file(scans));
  read_truth(*default_truth_file(scans), set);
  EXPECT_EQ(set.scans.size(), 120U);

  ScanScorer scorer;
  for (const LabelledScan& scan : set.scans) scorer.take(scan, walls_by_truth(scan));
  const ScanScore score = scorer.score();
  EXPECT_EQ(score.pieces_found, score.pieces);
  EXPECT_EQ(score.false_walls, 0);
  EXPECT_NEAR(score.angle_rms / kDegree, 0.329, 0.001);
  EXPECT_NEAR(1e3 * score.offset_rms, 1.02, 0.01);
  EXPECT_NEAR(1e3 * score.end_median, 0.9, 0.1);
  EXPECT_NEAR(percent(score.corners_found, score.corners), 99.5, 0.1);
  EXPECT_NEAR(percent(score.false_corners, score.corner_claims), 0.3, 0.1);
  EXPECT_NEAR(1e3 * score.corner_median, 1.72, 0.01);
  EXPECT_EQ(score.corner_mix_ups, 0);
}

}  // namespace
}  // namespace perceptor
