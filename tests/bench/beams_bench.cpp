/// @file What one scan costs, by beams: each way to find walls, beside the least that any has to
/// do, and the other things that are done with every scan.
#include <array>
#include <string>

#include <benchmark/benchmark.h>

#include "components/proximity/surroundings.hpp"
#include "components/scan/extractor.hpp"
#include "tests/bench/bench_scans.hpp"
#include "tests/bench/floor.hpp"

namespace perceptor {
namespace {

/// Scans of the same place with other noise, in turn: of a single one, the processor would learn
/// every branch by heart.
using Scans = std::array<LaserScan, 16>;

Scans scans_of(std::size_t beams, const Twist& twist) {
  Scans scans;
  for (std::size_t i = 0; i < scans.size(); ++i) scans[i] = scan_of(beams, twist, i + 1);
  return scans;
}

std::size_t beams_of(const benchmark::State& state) {
  return static_cast<std::size_t>(state.range(0));
}

void BeamCounts(benchmark::internal::Benchmark* bench) {
  for (const int beams : {180, 361, 1000, 1081, 10'000}) bench->Arg(beams);
}

void FloorOfExtraction(benchmark::State& state) {
  Floor floor(scan_of(beams_of(state), {}));
  for (auto _ : state) floor.run();
}
BENCHMARK(FloorOfExtraction)->Name("Floor")->Apply(BeamCounts);

/// x_floor: how many times the floor it takes, both measured here, one after the other.
void Extract(benchmark::State& state, scan::ScanMethod method, const Twist& twist,
             const std::vector<Vector2>& footprint) {
  const Scans scans = scans_of(beams_of(state), twist);
  scan::ScanParameters parameters;
  parameters.method = method;
  scan::WallExtractor extractor(parameters, footprint);
  for (const LaserScan& scan : scans) extractor.extract(scan, twist);

  const double floor = floor_time(scans.front());
  std::size_t next = 0;
  const double start = processor_time();
  for (auto _ : state) {
    benchmark::DoNotOptimize(extractor.extract(scans[next], twist));
    next = (next + 1) % scans.size();
  }
  const double each = (processor_time() - start) / static_cast<double>(state.iterations());
  state.counters["x_floor"] = each / floor;
  state.counters["walls"] = static_cast<double>(extractor.extract(scans[0], twist).walls.size());
}

void ExtractDriving(benchmark::State& state) {
  Extract(state, scan::ScanParameters{}.method, kDriving, kFootprint);
}

/// One benchmark for each method, whichever there are.
const bool registered = [] {
  for (const scan::NamedMethod& named : scan::kMethods) {
    const std::string name = "Extract/" + std::string(named.name);
    const auto run = [method = named.method](benchmark::State& state) {
      Extract(state, method, {}, {});
    };
    benchmark::RegisterBenchmark(name.c_str(), run)->Apply(BeamCounts);
  }
  return true;
}();
BENCHMARK(ExtractDriving)->Apply(BeamCounts);

void BeamEnds(benchmark::State& state) {
  const LaserScan scan = scan_of(beams_of(state), kDriving);
  for (auto _ : state) benchmark::DoNotOptimize(beam_ends(scan, kDriving));
}
BENCHMARK(BeamEnds)->Apply(BeamCounts);

void LookAround(benchmark::State& state) {
  const LaserScan scan = scan_of(beams_of(state), kDriving);
  for (auto _ : state) benchmark::DoNotOptimize(look_around(scan, kFootprint, {}));
}
BENCHMARK(LookAround)->Apply(BeamCounts);

}  // namespace
}  // namespace perceptor
