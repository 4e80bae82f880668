/// @file What one scan costs, by beams, beside the least that any line extraction has to do.
#include <cmath>

#include <benchmark/benchmark.h>

#include "components/proximity/surroundings.hpp"
#include "components/scan/scan.hpp"
#include "tests/support/scene.hpp"

namespace perceptor {
namespace {

const Twist kDriving{.vx = 0.5, .vy = 0.1, .va = 0.6};
const std::vector<Vector2> kFootprint = {{0.2, 0.2}, {-0.2, 0.2}, {-0.2, -0.2}, {0.2, -0.2}};

/// An L-shaped room with a pillar, seen by a moving robot's noisy laser:
///
///   +-----------+
///   |           |
///   |   []      +-----+
///   |  R              |
///   +-----------------+
LaserScan scan_of(const benchmark::State& state) {
  test::Scene scene = test::room({{-1, -1}, {5, -1}, {5, 1.5}, {3, 1.5}, {3, 4}, {-1, 4}});
  const test::Scene pillar = test::room({{0.8, 1}, {1.2, 1}, {1.2, 1.4}, {0.8, 1.4}});
  scene.insert(scene.end(), pillar.begin(), pillar.end());
  const auto beams = static_cast<std::size_t>(state.range(0));
  const test::SceneLaser laser{.bearings = test::fan(beams, -2.0, 2.0),
                               .laser_in_robot = {0.1, 0.0, 0.0},
                               .sigma = 0.005,
                               .sweep_time = 0.02};
  return test::sweep(scene, laser, {}, kDriving);
}

void BeamCounts(benchmark::internal::Benchmark* bench) {
  for (const int beams : {180, 361, 1000, 1081, 10'000}) bench->Arg(beams);
}

/// Polar to Cartesian, and prefix sums of the second moments.
void Floor(benchmark::State& state) {
  const LaserScan scan = scan_of(state);
  struct Sums {
    double x, y, xx, xy, yy;
  };
  std::vector<Sums> sums(scan.size() + 1);
  for (auto _ : state) {
    Sums sum{};
    for (std::size_t beam = 0; beam < scan.size(); ++beam) {
      const double x = scan.ranges[beam] * std::cos(scan.bearings[beam]);
      const double y = scan.ranges[beam] * std::sin(scan.bearings[beam]);
      sum = {sum.x + x, sum.y + y, sum.xx + x * x, sum.xy + x * y, sum.yy + y * y};
      sums[beam + 1] = sum;
    }
    benchmark::DoNotOptimize(sums.data());
    benchmark::ClobberMemory();
  }
}
BENCHMARK(Floor)->Apply(BeamCounts);

void BeamEnds(benchmark::State& state) {
  const LaserScan scan = scan_of(state);
  for (auto _ : state) benchmark::DoNotOptimize(beam_ends(scan, kDriving));
}
BENCHMARK(BeamEnds)->Apply(BeamCounts);

void ExtractWalls(benchmark::State& state) {
  const LaserScan scan = scan_of(state);
  for (auto _ : state)
    benchmark::DoNotOptimize(scan::extract_walls(scan, kDriving, kFootprint, {}));
}
BENCHMARK(ExtractWalls)->Apply(BeamCounts);

void LookAround(benchmark::State& state) {
  const LaserScan scan = scan_of(state);
  for (auto _ : state) benchmark::DoNotOptimize(look_around(scan, kFootprint, {}));
}
BENCHMARK(LookAround)->Apply(BeamCounts);

}  // namespace
}  // namespace perceptor
