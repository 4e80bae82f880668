/// @file One sweep of the laser, and where its beams end.
#pragma once

#include <cstddef>
#include <vector>

#include "common/geometry/twist.hpp"

namespace perceptor {

/// One sweep as measured, beams in the order in which they were measured.
struct LaserScan {
  Position laser_in_robot;
  double time_increment = 0.0;   ///< [s] from beam to beam; 0: all at once
  double valid_min = 0.0;        ///< [m]
  double valid_max = 0.0;        ///< [m]
  double range_sigma = 0.0;      ///< [m] standard deviation of a valid range
  std::vector<double> bearings;  ///< [rad] laser frame
  std::vector<double> ranges;    ///< [m] as measured, "no return" included

  std::size_t size() const { return ranges.size(); }
};

/// Whether a range is a return at all: finite, positive, within [valid_min, valid_max].
/// Everything else is unknown, never free.
bool is_return(const LaserScan& scan, double range);

/// Beams that returned.
std::size_t count_returns(const LaserScan& scan);

/// Where one beam ends.
struct BeamEnd {
  Vector2 location;      ///< [m] robot frame at the time of the first beam
  Vector2 origin;        ///< [m] where the laser was when it measured, same frame
  double range = 0.0;    ///< [m] along the beam
  std::size_t beam = 0;  ///< index into the scan
};

/// The ends of all beams that returned, in the robot frame at the time of the first beam.
/// The robot moves at `twist` while the laser sweeps, and each beam is laid from where the
/// laser was at its own time. Sorted by bearing, counter-clockwise from the scan's smallest.
std::vector<BeamEnd> beam_ends(const LaserScan& scan, const Twist& twist = {});

}  // namespace perceptor
