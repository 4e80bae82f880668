/// @file What merge and identify cost, by walls of the map.
#include <benchmark/benchmark.h>

#include "components/identify/identify.hpp"
#include "components/merge/merger.hpp"
#include "tests/bench/row_of_rooms.hpp"

namespace perceptor {
namespace {

constexpr std::int64_t kScanPeriod = 25'000;  // [us]

void WallCounts(benchmark::internal::Benchmark* bench) {
  for (const int walls : {10, 30, 100}) bench->Arg(walls);
}

/// All walls of the map are seen again in every scan.
void Merge(benchmark::State& state) {
  merge::Merger merger{merge::MergeParameters{}};
  merge::ScanMap scan;
  scan.walls = row_of_rooms(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    scan.utime += kScanPeriod;
    benchmark::DoNotOptimize(merger.update(scan));
  }
  state.counters["walls"] = static_cast<double>(merger.walls().size());
}
BENCHMARK(Merge)->Apply(WallCounts);

/// A robot that drives along 25 walls at a time, and looks at the last 25 of them.
void MergeInView(benchmark::State& state) {
  merge::Merger merger{merge::MergeParameters{}};
  merge::ScanMap scan;
  scan.laser_in_robot = {-12.0, -3.0, 0.0};  // before the middle of what it sees
  scan.walls = row_of_rooms(25);
  const auto see = [&] {
    scan.utime += kScanPeriod;
    return merger.update(scan);
  };
  for (int place = 0; place < state.range(0); ++place) {
    scan.robot_in_zero.x = -25.0 * place;
    for (int i = 0; i < 40; ++i) see();
  }
  for (auto _ : state) benchmark::DoNotOptimize(see());
  state.counters["walls"] = static_cast<double>(merger.walls().size());
}
BENCHMARK(MergeInView)->Arg(1)->Arg(5);

void Identify(benchmark::State& state) {
  const Map local_map = row_of_rooms(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    Map map = local_map;
    benchmark::DoNotOptimize(identify::identify(map, Vector2(-4.0, -1.0)));
  }
}
BENCHMARK(Identify)->Apply(WallCounts);

}  // namespace
}  // namespace perceptor
