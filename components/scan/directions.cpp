#include "components/scan/directions.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>
#include <numeric>

namespace perceptor::scan {
namespace {

/// Byte by byte, which is faster than number by number.
bool is_same(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() != b.size()) return false;
  return a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

}  // namespace

void Directions::update(const LaserScan& scan) {
  if (is_same(scan.bearings, bearings_) && scan.laser_in_robot.a == heading_) return;
  bearings_ = scan.bearings;
  heading_ = scan.laser_in_robot.a;

  order_.resize(bearings_.size());
  std::iota(order_.begin(), order_.end(), 0U);
  is_sorted_ = std::ranges::is_sorted(bearings_);
  if (!is_sorted_)
    std::ranges::stable_sort(order_, {}, [this](std::uint32_t beam) { return bearings_[beam]; });
  cosine_.resize(bearings_.size());
  sine_.resize(bearings_.size());
  for (std::size_t beam = 0; beam < bearings_.size(); ++beam) {
    cosine_[beam] = std::cos(heading_ + bearings_[beam]);
    sine_[beam] = std::sin(heading_ + bearings_[beam]);
  }
  increment_ = 0.0;
  is_circle_ = false;
  if (bearings_.size() < 2) return;
  const double span = bearings_[order_.back()] - bearings_[order_.front()];
  increment_ = span / static_cast<double>(bearings_.size() - 1);
  is_circle_ = span + 2.0 * increment_ >= 2.0 * std::numbers::pi;
}

}  // namespace perceptor::scan
