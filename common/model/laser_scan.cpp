#include "common/model/laser_scan.hpp"

#include <algorithm>
#include <cmath>

#include "common/model/sweeping_laser.hpp"

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
  SweepingLaser laser(scan.laser_in_robot, twist, scan.time_increment);
  for (std::size_t beam = 0; beam < scan.size(); ++beam) {
    const auto [origin, cosine, sine] = laser.next();
    const double range = scan.ranges[beam];
    if (!is_return(scan, range)) continue;
    const double direction = scan.laser_in_robot.a + scan.bearings[beam];
    const double x = std::cos(direction);
    const double y = std::sin(direction);
    const Vector2 along(cosine * x - sine * y, sine * x + cosine * y);
    ends.push_back(
        {.location = origin + range * along, .origin = origin, .range = range, .beam = beam});
  }
  const auto bearing = [&scan](const BeamEnd& end) { return scan.bearings[end.beam]; };
  if (!std::ranges::is_sorted(ends, {}, bearing)) std::ranges::stable_sort(ends, {}, bearing);
  return ends;
}

}  // namespace perceptor
