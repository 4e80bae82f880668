#include "tools/eval/floor.hpp"

#include <cmath>

namespace perceptor {

Floor::Floor(const std::vector<double>& bearings) : sums_(bearings.size() + 1) {
  for (const double bearing : bearings) {
    cosines_.push_back(std::cos(bearing));
    sines_.push_back(std::sin(bearing));
  }
}

void Floor::run(const LaserScan& scan) {
  Sums sum;
  for (std::size_t i = 0; i < cosines_.size(); ++i) {
    const double r = scan.ranges[i];
    const double x = r * cosines_[i];
    const double y = r * sines_[i];
    const double w = r * r;
    const double wx = w * x;
    const double wy = w * y;
    sum.w += w;
    sum.wx += wx;
    sum.wy += wy;
    sum.wxx += wx * x;
    sum.wxy += wx * y;
    sum.wyy += wy * y;
    sums_[i + 1] = sum;
  }
}

}  // namespace perceptor
