// The iterative end-point fit by itself.

#include <gtest/gtest.h>

#include "tests/unit/components/scan/scan_scene.hpp"

namespace perceptor::test {
namespace {

using namespace perceptor::scan;

/// Without the step that merges: no chi-square is enough.
ScanParameters without_merging() {
  ScanParameters parameters;
  parameters.method = ScanMethod::endpoint_fit;
  parameters.wall.merge_chi2 = -1e12;
  return parameters;
}

std::vector<RunResult> runs_of(const LaserScan& scan, const ScanParameters& parameters) {
  WallExtractor extractor(parameters);
  extractor.extract(scan);
  return extractor.runs();
}

TEST(EndpointFit, MergesWhatItSplitAtAnOutlier) {
  LaserScan scan = sweep({{{2, -2}, {2, 2}}}, pico_laser(0.005));
  scan.ranges[500] += 0.1;  // too close to the wall to be taken out as a stray
  ScanParameters parameters = without_merging();
  EXPECT_GE(runs_of(scan, parameters).size(), 2U) << "the test would show nothing";
  parameters.wall.merge_chi2 = ScanParameters{}.wall.merge_chi2;
  EXPECT_EQ(runs_of(scan, parameters).size(), 1U);
}

TEST(EndpointFit, CutsAtTheCorner) {
  const std::vector<Vector2> corners = {{2, -1.5}, {2, 0.5}, {1, 0.5}};
  const LaserScan scan = sweep(chain(corners), pico_laser());
  const std::vector<RunResult> runs = runs_of(scan, without_merging());
  ASSERT_EQ(runs.size(), 2U);
  EXPECT_EQ(runs[0].run.end, runs[1].run.begin);
  WallExtractor extractor(without_merging());
  extractor.extract(scan);
  // Beams are 0.01 m apart there.
  EXPECT_LT(distance(extractor.sweep().beams.location(runs[1].run.begin), corners[1]), 0.011);
}

TEST(EndpointFit, SplitsAWallNoMoreOftenWhereItIsNoisier) {
  for (const double sigma : {0.003, 0.01, 0.03, 0.1}) {
    std::size_t runs = 0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed)
      runs +=
          runs_of(sweep({{{2, -2}, {2, 2}}}, pico_laser(sigma, seed)), without_merging()).size();
    // A beam of 300 or so lies beyond 3 sigmas of noise now and then, and so do the parts.
    EXPECT_LE(runs, 80U) << "in 20 scans with sigma " << sigma;
  }
}

}  // namespace
}  // namespace perceptor::test
