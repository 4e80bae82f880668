/// @file What any extractor of lines with constant-time fits has to do at least: points from
/// polar coordinates, and the sums from which the best line through any run of beams follows.
/// Its time makes those measured on different machines comparable.
#pragma once

#include <vector>

#include "common/model/laser_scan.hpp"

namespace perceptor {

class Floor {
 public:
  /// Makes the tables; scans must have these bearings [rad].
  explicit Floor(const std::vector<double>& bearings);

  /// This is what is timed.
  void run(const LaserScan& scan);

  /// Over the beams before a beam, weighted with their squared range w: of w, w x and so on.
  struct Sums {
    double w = 0.0;   ///< [m^2]
    double wx = 0.0;  ///< [m^3]
    double wy = 0.0;
    double wxx = 0.0;  ///< [m^4]
    double wxy = 0.0;
    double wyy = 0.0;
  };
  const std::vector<Sums>& sums() const { return sums_; }

 private:
  std::vector<double> cosines_;
  std::vector<double> sines_;
  std::vector<Sums> sums_;
};

}  // namespace perceptor
