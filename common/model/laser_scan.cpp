#include "common/model/laser_scan.hpp"

#include <algorithm>
#include <cmath>

namespace perceptor {

bool is_return(const LaserScan& scan, double range) {
  return std::isfinite(range) && range > 0.0 && range >= scan.valid_min && range <= scan.valid_max;
}

std::size_t count_returns(const LaserScan& scan) {
  return static_cast<std::size_t>(
      std::ranges::count_if(scan.ranges, [&scan](double range) { return is_return(scan, range); }));
}

std::vector<BeamEnd> beam_ends(const LaserScan& scan, const Twist& twist) {
  std::vector<BeamEnd> ends;
  ends.reserve(scan.size());
  for (std::size_t beam = 0; beam < scan.size(); ++beam) {
    const double range = scan.ranges[beam];
    if (!is_return(scan, range)) continue;
    const double seconds = static_cast<double>(beam) * scan.time_increment;
    const Position robot_in_start = move(twist, seconds);
    const Position laser_in_start = compose(robot_in_start, scan.laser_in_robot);
    const double bearing = scan.bearings[beam];
    const Vector2 end_in_laser(range * std::cos(bearing), range * std::sin(bearing));
    ends.push_back({.location = transform(laser_in_start, end_in_laser),
                    .origin = laser_in_start.location(),
                    .range = range,
                    .beam = beam});
  }
  std::ranges::stable_sort(ends, {},
                           [&scan](const BeamEnd& end) { return scan.bearings[end.beam]; });
  return ends;
}

}  // namespace perceptor
