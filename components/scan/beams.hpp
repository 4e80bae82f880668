/// @file The beams that can belong to a wall, in order, with what is known of their noise.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "common/model/laser_scan.hpp"
#include "components/scan/directions.hpp"
#include "components/scan/parameters.hpp"

namespace perceptor::scan {

/// Beams that returned from something that is not the robot, counter-clockwise. Where the sweep
/// closes a circle it begins at its widest step, and all beams follow a second time, so that a
/// run of beams may pass the seam: valid indices are then 0 to 2 count - 1.
///
/// One array for each quantity: what is done to every beam is done to several at a time.
struct Beams {
  std::vector<double> x;            ///< [m] where it ends, from `laser`, robot frame's axes
  std::vector<double> y;            ///< [m]
  std::vector<double> range;        ///< [m]
  std::vector<double> weight;       ///< [-] (range / sigma)^2, see line_fit.hpp
  std::vector<double> bearing;      ///< [rad] laser frame, rising all the way: past the seam of
                                    ///< a circle it goes on
  std::vector<std::uint32_t> beam;  ///< index into the scan

  std::size_t count = 0;         ///< of different beams
  bool is_circle = false;        ///< the sweep goes all around: the first beam follows the last
  double increment = 0.0;        ///< [rad] mean step of bearing
  double grazing = 1.0;          ///< [-] 1 / sin(min_incidence): distance of neighbours on the most
                                 ///< grazing wall, over their distance across the beam
  double max_hole = 0.0;         ///< [m] of a wall from which no beam returned
  double range_sigma = 0.0;      ///< [m] of the sensor
  double sigma_growth = 0.0;     ///< [m/m]
  Vector2 laser{0.0, 0.0};       ///< [m] half-way through the sweep, robot frame
  std::size_t no_return = 0;     ///< beams of the scan left out: no usable range
  std::size_t in_footprint = 0;  ///< beams of the scan left out: they end on the robot itself

  /// Where a beam ends [m], from `laser`.
  Vector2 end(std::size_t i) const { return {x[i], y[i]}; }
  /// Where a beam ends [m], robot frame.
  Vector2 location(std::size_t i) const { return laser + end(i); }
  /// Standard deviation of the range [m].
  double sigma(std::size_t i) const;
};

/// Makes beams of scans. Keeps what a laser's scans have in common, and all memory.
class BeamReader {
 public:
  /// `footprint`: a polygon in the robot frame; fewer than three corners: none.
  BeamReader(const NoiseParameters& noise, const GapParameters& gap,
             std::vector<Vector2> footprint);

  /// All beams that returned from outside the footprint. The robot moves at `twist` while the
  /// laser sweeps.
  void read(const LaserScan& scan, const Twist& twist, Beams& beams);

 private:
  void lay_out(const LaserScan& scan, const Twist& twist, Beams& beams) const;
  void put_in_order(const LaserScan& scan, Beams& beams);
  void keep_returns(const LaserScan& scan, Beams& beams) const;

  NoiseParameters noise_;
  GapParameters gap_;
  std::vector<Vector2> footprint_;
  Directions directions_;
  std::vector<double> in_order_;  // working memory
};

/// Appends all beams once more, those of a circle.
void repeat(Beams& beams);

/// Variance of a beam across a line [m^2]; `line_distance` is the line's from the laser [m].
double variance_across(const Beams& beams, std::size_t i, double line_distance,
                       const NoiseParameters& noise);

/// Distance of neighbouring beams on a line with this normal [m].
double distance_between_beams(const Beams& beams, std::size_t i, const Vector2& normal);

}  // namespace perceptor::scan
