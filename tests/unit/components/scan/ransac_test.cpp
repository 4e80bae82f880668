// Random sample consensus by itself.

#include <gtest/gtest.h>

#include "tests/unit/components/scan/scan_scene.hpp"

namespace perceptor::test {
namespace {

using namespace perceptor::scan;

ScanParameters ransac_parameters(std::int64_t seed = 1) {
  ScanParameters parameters;
  parameters.method = ScanMethod::ransac;
  parameters.ransac.seed = seed;
  return parameters;
}

std::vector<Run> runs_of(WallExtractor& extractor, const LaserScan& scan) {
  extractor.extract(scan);
  std::vector<Run> runs;
  for (const RunResult& result : extractor.runs()) runs.push_back(result.run);
  return runs;
}

TEST(Ransac, DrawsTheSameWhateverWasSeenBefore) {
  const LaserScan scan = sweep(room(room_corners()), pico_laser(0.02, 5));
  WallExtractor fresh(ransac_parameters());
  const auto expected = runs_of(fresh, scan);
  WallExtractor used(ransac_parameters());
  runs_of(used, sweep(room({{-3, -1}, {1, -2}, {2, 3}}), pico_laser(0.01)));
  const auto runs = runs_of(used, scan);
  ASSERT_EQ(runs.size(), expected.size());
  for (std::size_t i = 0; i < runs.size(); ++i) {
    EXPECT_EQ(runs[i].begin, expected[i].begin);
    EXPECT_EQ(runs[i].end, expected[i].end);
    EXPECT_EQ(runs[i].moments.beams, expected[i].moments.beams);
  }
}

TEST(Ransac, ShowsTheRoomWhateverTheSeed) {
  SceneLaser laser;
  laser.bearings = circle(1000);
  laser.sigma = 0.01;
  const LaserScan scan = sweep(room(room_corners()), laser);
  for (std::int64_t seed = 0; seed < 30; ++seed)
    EXPECT_TRUE(shows_the_room(map_of(scan, {}, ransac_parameters(seed)), {}, 0.02)) << seed;
}

TEST(Ransac, BridgesAFewStraysAndLeavesThemOut) {
  LaserScan scan = sweep({{{2, -2}, {2, 2}}}, pico_laser());
  for (std::size_t beam = 500; beam < 504; ++beam) scan.ranges[beam] += 0.08;
  WallExtractor extractor(ransac_parameters());
  const auto runs = runs_of(extractor, scan);
  ASSERT_EQ(runs.size(), 1U);
  const auto& run = runs.front();
  EXPECT_EQ(run.moments.beams, static_cast<double>(run.size() - 4));
  const std::vector<std::uint32_t>& beam = extractor.sweep().beams.beam;
  EXPECT_EQ(beam[run.solid_until], 500U);
  EXPECT_EQ(beam[run.solid_from], 504U);
}

TEST(Ransac, LeavesOutWhatNoLineExplains) {
  // Beams without any order, close enough to each other to be no gaps.
  LaserScan scan = sweep({{{2, -2}, {2, 2}}}, pico_laser());
  for (std::size_t beam = 0; beam < scan.size(); ++beam)
    scan.ranges[beam] = 2.0 + 0.04 * std::sin(static_cast<double>(7919 * beam * beam));
  WallExtractor extractor(ransac_parameters());
  EXPECT_TRUE(extractor.extract(scan).walls.empty());
}

}  // namespace
}  // namespace perceptor::test
