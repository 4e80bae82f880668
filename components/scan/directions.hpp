/// @file Where the beams of a laser point, kept from scan to scan.
#pragma once

#include <cstdint>
#include <vector>

#include "common/model/laser_scan.hpp"

namespace perceptor::scan {

/// The directions of a sweep's beams, counter-clockwise. A laser points the same way scan after
/// scan, so that sines and cosines are computed once, and again only where a scan differs.
class Directions {
 public:
  void update(const LaserScan& scan);

  std::size_t size() const { return order_.size(); }
  /// The beams, by bearing; equal bearings stay in the order of measurement.
  const std::vector<std::uint32_t>& order() const { return order_; }
  /// Whether the beams were measured in that order.
  bool is_sorted() const { return is_sorted_; }
  /// By beam, as measured: the direction in the robot frame, without the robot's motion.
  const std::vector<double>& cosine() const { return cosine_; }
  const std::vector<double>& sine() const { return sine_; }
  /// Mean step of bearing [rad].
  double increment() const { return increment_; }
  /// Whether the sweep goes all around: the first beam follows the last.
  bool is_circle() const { return is_circle_; }

 private:
  std::vector<double> bearings_;  // [rad] of the scan that all this belongs to
  double heading_ = 0.0;          // [rad] of its laser in the robot frame
  std::vector<std::uint32_t> order_;
  bool is_sorted_ = true;
  std::vector<double> cosine_;
  std::vector<double> sine_;
  double increment_ = 0.0;
  bool is_circle_ = false;
};

}  // namespace perceptor::scan
