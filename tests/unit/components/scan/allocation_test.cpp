// After its first scan, extraction allocates nothing.

#include <gtest/gtest.h>

#include "tests/support/allocation_watch.hpp"
#include "tests/unit/components/scan/each_method.hpp"
#include "tests/unit/components/scan/scan_scene.hpp"

namespace perceptor::test {
namespace {

using namespace perceptor::scan;

using Allocations = EachMethod;
INSTANTIATE_TEST_SUITE_P(All, Allocations, testing::ValuesIn(kMethods), name_of);

constexpr Twist kDriving{.vx = 0.4, .vy = -0.1, .va = 0.5};

/// The same place with other noise.
std::vector<LaserScan> scans_of(SceneLaser laser, std::uint64_t first_seed, std::uint64_t count) {
  laser.sigma = 0.01;
  laser.sweep_time = 0.02;
  Scene scene = room(room_corners());
  const Scene box = room({{0.8, 0.5}, {1.3, 0.5}, {1.3, 0.9}, {0.8, 0.9}});
  scene.insert(scene.end(), box.begin(), box.end());
  std::vector<LaserScan> scans;
  for (std::uint64_t i = 0; i < count; ++i) {
    laser.seed = first_seed + i;
    scans.push_back(sweep(scene, laser, {-0.4, -0.2, 0.3}, kDriving));
  }
  return scans;
}

std::size_t allocations_after_the_first(const ScanParameters& parameters, SceneLaser laser) {
  WallExtractor extractor(parameters, {{0.2, 0.2}, {-0.2, 0.2}, {-0.2, -0.2}, {0.2, -0.2}});
  // Fewer beams return than later, and fewer of them are strays.
  laser.dropouts = 0.1;
  extractor.extract(scans_of(laser, 1, 1).front(), kDriving);
  laser.outliers = 0.01;
  laser.dropouts = 0.01;
  const std::vector<LaserScan> scans = scans_of(laser, 101, 100);
  forget_allocations();
  for (const LaserScan& scan : scans) extractor.extract(scan, kDriving);
  return allocations();
}

TEST_P(Allocations, AreNoneAfterTheFirstScan) {
  EXPECT_EQ(allocations_after_the_first(parameters(), pico_laser()), 0U);
}

TEST_P(Allocations, AreNoneInACircleOfUnsortedBeams) {
  SceneLaser laser;
  laser.bearings = fan(1000, std::numbers::pi, -std::numbers::pi + 0.006);
  EXPECT_EQ(allocations_after_the_first(parameters(), laser), 0U);
}

TEST(AllocationWatch, SeesThoseOfAFirstScan) {
  const std::vector<LaserScan> scans = scans_of(pico_laser(), 1, 1);
  WallExtractor extractor({});
  forget_allocations();
  extractor.extract(scans.front());
  EXPECT_GT(allocations(), 0U) << "the test would show nothing";
}

}  // namespace
}  // namespace perceptor::test
