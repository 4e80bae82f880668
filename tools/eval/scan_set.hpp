/// @file Single scans with the truth about them: what extractors of walls are scored on.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/geometry/segment.hpp"
#include "common/model/laser_scan.hpp"

namespace perceptor {

/// A contiguous piece of a true wall that the scan sees, in the laser's frame.
struct TruePiece {
  int edge = 0;                 ///< the wall of the map; several pieces may be of one
  std::size_t first_beam = 0;   ///< whose end is the piece's first
  std::size_t last_beam = 0;    ///< whose end is the piece's last; inclusive
  std::size_t returns = 0;      ///< beams in between with a return
  bool has_to_be_found = true;  ///< at least 10 returns and 0.3 m; others count neither way
  Segment segment;              ///< [m] where the first and the last beam meet the wall, exact
};

/// A corner of which both walls are seen.
struct TrueCorner {
  Vector2 location = Vector2::Zero();  ///< [m] laser frame
  bool is_convex = false;              ///< sticks out into free space
  bool has_to_be_found = true;
};

struct LabelledScan {
  std::int64_t id = 0;
  double time = 0.0;  ///< [s]
  Position odometry;
  Position laser_in_world;
  LaserScan scan;  ///< where there is truth, laser_in_robot is zero: robot and laser frame are one
  std::vector<TruePiece> pieces;
  std::vector<TrueCorner> corners;
  std::vector<Segment> doors;  ///< [m] openings, jamb to jamb
};

struct ScanSet {
  std::vector<LabelledScan> scans;
  std::vector<Vector2> footprint;  ///< [m] outline of the robot that carries the laser, robot
                                   ///< frame; empty: none
  bool has_truth = false;
};

}  // namespace perceptor
