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
