#include "common/model/laser_scan.hpp"

#include <algorithm>
#include <cmath>

namespace perceptor {
namespace {

/// A slower turn [rad/s] bends the way of no sweep by as much as rounding does.
constexpr double kSlowestTurn = 1e-12;

/// Where the laser is while the robot moves at constant twist and the laser sweeps: the same as
/// compose(move(twist, seconds), laser_in_robot), for thousands of beams a sweep. A robot that
/// turns does so about a centre, and its laser goes round that in a circle.
class SweepingLaser {
 public:
  /// Robot frame at the time of the first beam.
  struct Place {
    Vector2 origin;  ///< [m]
    double heading;  ///< [rad] not wrapped
  };

  SweepingLaser(const Position& laser_in_robot, const Twist& twist)
      : start_(laser_in_robot), velocity_(twist.vx, twist.vy), turn_rate_(twist.va) {
    if (!turns()) return;
    along_circle_ = velocity_ / turn_rate_ + perpendicular(start_.location());
    to_centre_ = perpendicular(along_circle_);
  }

  Place at(double seconds) const {
    if (!turns()) return {start_.location() + seconds * velocity_, start_.a};
    const double turn = turn_rate_ * seconds;
    // Both sin(turn) and 1 - cos(turn) without cancellation, from half of the turn.
    const double half_sine = std::sin(0.5 * turn);
    const double sine = 2.0 * half_sine * std::cos(0.5 * turn);
    const double versine = 2.0 * half_sine * half_sine;
    return {start_.location() + sine * along_circle_ + versine * to_centre_, start_.a + turn};
  }

 private:
  bool turns() const { return std::abs(turn_rate_) > kSlowestTurn; }

  Position start_;
  Vector2 velocity_;                        // [m/s]
  double turn_rate_;                        // [rad/s]
  Vector2 to_centre_ = Vector2::Zero();     // [m] of the circle, from the start
  Vector2 along_circle_ = Vector2::Zero();  // [m] as long, in the direction of the motion
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
