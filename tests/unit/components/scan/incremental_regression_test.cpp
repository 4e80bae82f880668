// Incremental regression by itself.

#include "components/scan/incremental_regression.hpp"

#include <gtest/gtest.h>

#include "tests/unit/components/scan/scan_scene.hpp"

namespace perceptor::test {
namespace {

using namespace perceptor::scan;

struct Grown {
  std::vector<Run> runs;
  Beams beams;
};

Grown grown(const LaserScan& scan) {
  ScanParameters parameters;
  parameters.method = ScanMethod::incremental_regression;
  WallExtractor extractor(parameters);
  extractor.extract(scan);
  Grown found{.runs = {}, .beams = extractor.sweep().beams};
  for (const RunResult& result : extractor.runs()) found.runs.push_back(result.run);
  return found;
}

TEST(IncrementalRegression, GrowsToTheCornerAndStops) {
  const std::vector<Vector2> corners = {{2, -1.5}, {2, 0.5}, {1, 0.5}};
  const Grown found = grown(sweep(chain(corners), pico_laser()));
  ASSERT_EQ(found.runs.size(), 2U);
  EXPECT_EQ(found.runs[0].begin, 0U);
  EXPECT_EQ(found.runs[1].end, found.beams.count);
  // Three sigmas of noise and roughness across the wall are 0.01 m; beams are as far apart.
  EXPECT_LT(distance(found.beams.location(found.runs[1].begin), corners[1]), 0.03);
}

///      .
///       \   the wall behind the corner in the way of the sweep loses its first beams,
///        +  whichever of the two that is
///       /
///      '
TEST(IncrementalRegression, GrowsPastAFlatCornerInItsOwnDirection) {
  const Scene scene = chain({{2.4, -2}, {2, 0}, {2.4, 2}});
  double behind = 0.0;  // [rad]
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const LaserScan scan = sweep(scene, pico_laser(0.01, seed));
    LaserScan mirrored = scan;
    for (double& bearing : mirrored.bearings) bearing = -bearing;
    for (const LaserScan& way : {scan, mirrored}) {
      const Grown found = grown(way);
      ASSERT_EQ(found.runs.size(), 2U);
      behind += found.beams.bearing[found.runs[1].begin] / 20.0;
    }
  }
  EXPECT_GT(behind, 0.004) << "a beam, on average";
}

TEST(IncrementalRegression, GoesOnBehindASingleOutlier) {
  LaserScan scan = sweep({{{2, -2}, {2, 2}}}, pico_laser(0.005));
  scan.ranges[500] += 0.1;  // too close to the wall to be taken out as a stray
  const Grown found = grown(scan);
  ASSERT_EQ(found.runs.size(), 1U);
  EXPECT_EQ(found.runs[0].moments.beams, static_cast<double>(found.runs[0].size() - 1));
}

}  // namespace
}  // namespace perceptor::test
