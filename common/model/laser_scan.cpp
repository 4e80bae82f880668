#include "common/model/laser_scan.hpp"

#include <algorithm>
#include <cmath>

namespace perceptor {
namespace {

/// Where the laser is while the robot moves at constant twist and the laser sweeps: the same as
/// compose(move(twist, seconds), laser_in_robot), for thousands of beams a sweep.
class SweepingLaser {
 public:
  /// Robot frame at the time of the first beam.
  struct Place {
    Vector2 origin;  ///< [m]
    double heading;  ///< [rad] not wrapped
  };

  SweepingLaser(const Position& laser_in_robot, const Twist& twist)
      : laser_in_robot_(laser_in_robot), offset_(laser_in_robot.location()), twist_(twist) {}

  Place at(double seconds) const {
    const double turn = twist_.va * seconds;
    const Vector2 travel(twist_.vx * seconds, twist_.vy * seconds);
    if (turn == 0.0) return {travel + offset_, laser_in_robot_.a};
    // Both sin(turn) and 1 - cos(turn) without cancellation, from half of the turn.
    const double half_sine = std::sin(0.5 * turn);
    const double sine = 2.0 * half_sine * std::cos(0.5 * turn);
    const double versine = 2.0 * half_sine * half_sine;
    const Vector2 robot = sine / turn * travel + versine / turn * perpendicular(travel);
    const Vector2 turned_offset = offset_ + sine * perpendicular(offset_) - versine * offset_;
    return {robot + turned_offset, laser_in_robot_.a + turn};
  }

 private:
  Position laser_in_robot_;
  Vector2 offset_;
  Twist twist_;
};

}  // namespace

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
  const SweepingLaser laser(scan.laser_in_robot, twist);
  for (std::size_t beam = 0; beam < scan.size(); ++beam) {
    const double range = scan.ranges[beam];
    if (!is_return(scan, range)) continue;
    const auto [origin, heading] = laser.at(static_cast<double>(beam) * scan.time_increment);
    const double direction = heading + scan.bearings[beam];
    ends.push_back({.location = origin + range * Vector2(std::cos(direction), std::sin(direction)),
                    .origin = origin,
                    .range = range,
                    .beam = beam});
  }
  const auto bearing = [&scan](const BeamEnd& end) { return scan.bearings[end.beam]; };
  if (!std::ranges::is_sorted(ends, {}, bearing)) std::ranges::stable_sort(ends, {}, bearing);
  return ends;
}

}  // namespace perceptor
