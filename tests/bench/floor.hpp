/// @file The least that any line extraction has to do with a scan.
#pragma once

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <vector>

#include <benchmark/benchmark.h>

#include "common/model/laser_scan.hpp"

namespace perceptor {

/// Polar to Cartesian with tables of sine and cosine, and prefix sums of the moments, into memory
/// that is there already.
class Floor {
 public:
  explicit Floor(const LaserScan& scan) : ranges_(scan.ranges), sums_(scan.size() + 1) {
    for (const double bearing : scan.bearings) {
      cosine_.push_back(std::cos(bearing));
      sine_.push_back(std::sin(bearing));
    }
  }

  void run() {
    Sums sum{};
    for (std::size_t beam = 0; beam < ranges_.size(); ++beam) {
      const double x = ranges_[beam] * cosine_[beam];
      const double y = ranges_[beam] * sine_[beam];
      const double w = ranges_[beam] * ranges_[beam];
      const double wx = w * x;
      const double wy = w * y;
      sum = {sum.w + w, sum.x + wx, sum.y + wy, sum.xx + wx * x, sum.xy + wx * y, sum.yy + wy * y};
      sums_[beam + 1] = sum;
    }
    benchmark::DoNotOptimize(sums_.data());
    benchmark::ClobberMemory();
  }

 private:
  struct Sums {
    double w, x, y, xx, xy, yy;
  };
  std::vector<double> ranges_;
  std::vector<double> cosine_;
  std::vector<double> sine_;
  std::vector<Sums> sums_;
};

/// Of the processor on this program [s].
inline double processor_time() {
  return static_cast<double>(std::clock()) / static_cast<double>(CLOCKS_PER_SEC);
}

/// Processor time [s], the least of several batches: what else the machine does counts little.
inline double floor_time(const LaserScan& scan) {
  constexpr int kBatches = 20;
  constexpr std::size_t kBeamsInABatch = 200'000;
  Floor floor(scan);
  const std::size_t runs = 1 + kBeamsInABatch / scan.size();
  double least = std::numeric_limits<double>::infinity();
  for (int batch = 0; batch < kBatches; ++batch) {
    const double start = processor_time();
    for (std::size_t i = 0; i < runs; ++i) floor.run();
    least = std::min(least, (processor_time() - start) / static_cast<double>(runs));
  }
  return least;
}

}  // namespace perceptor
