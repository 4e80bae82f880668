/// @file The beams that can belong to a wall, in order, with what is known of their noise.
#pragma once

#include <cstddef>
#include <vector>

#include "common/model/laser_scan.hpp"
#include "components/scan/parameters.hpp"

namespace perceptor::scan {

/// One beam that returned from something that is not the robot.
struct Beam {
  Vector2 location;      ///< [m] where it ends, robot frame at the scan's utime
  Vector2 along;         ///< unit vector from the laser to there
  double range = 0.0;    ///< [m]
  double sigma = 0.0;    ///< [m] standard deviation of the range
  double bearing = 0.0;  ///< [rad] as measured, laser frame
};

/// Beams counter-clockwise. Where the sweep closes a circle it begins at its farthest beam,
/// and all beams follow a second time, so that a run of beams may pass the seam: valid
/// indices are then 0 to 2 count - 1.
struct Beams {
  std::vector<Beam> beams;
  std::size_t count = 0;         ///< of different beams
  bool is_circle = false;        ///< the sweep goes all around: the first beam follows the last
  double increment = 0.0;        ///< [rad] mean step of bearing
  double grazing = 1.0;          ///< [-] 1 / sin(min_incidence): distance of neighbours on the most
                                 ///< grazing wall, over their distance across the beam
  double max_hole = 0.0;         ///< [m] of a wall from which no beam returned
  Vector2 laser{0.0, 0.0};       ///< [m] where the laser was half-way through the sweep
  std::size_t no_return = 0;     ///< beams of the scan left out: no usable range
  std::size_t in_footprint = 0;  ///< beams of the scan left out: they end on the robot itself

  const Beam& operator[](std::size_t i) const { return beams[i]; }
};

/// Keeps the ends of beams that returned from outside `footprint` (a polygon in the robot
/// frame; fewer than three corners: no footprint), without beams that jump away from both
/// their neighbours while those belong together.
Beams usable_beams(const LaserScan& scan, const Twist& twist, const std::vector<Vector2>& footprint,
                   const ScanParameters& parameters);

/// Whether a wall cannot go on from beam i to the later beam j. On a wall that is hit at an
/// angle of at least `min_incidence`, neighbours are no further apart than the law of sines
/// allows (the adaptive breakpoint detector of Borges and Aldon, "Line extraction in 2D range
/// images for mobile robotics", 2004); where beams are missing, `max_hole` bounds it as well.
bool is_gap(const Beams& beams, std::size_t i, std::size_t j);

/// Variance of a beam across a line with this normal [m^2].
double variance_across(const Beam& beam, const Vector2& normal, const NoiseParameters& noise);

/// Distance of neighbouring beams on a line with this normal [m].
double distance_between_beams(const Beams& beams, const Beam& beam, const Vector2& normal);

}  // namespace perceptor::scan
