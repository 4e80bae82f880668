/// @file The text format of recordings:
///
///     # key value                                        header lines, all at the top
///     ODOM   t x y theta                                 [s] [m] [m] [rad]
///     LASER  t angle_min angle_increment range_max n r1 .. rn
///     LASERA t range_max n a1 r1 .. an rn                irregular: bearing, range
///
/// Of the header, `laser_pose x y theta` (the laser in the robot frame), `valid_min` and
/// `valid_max` are used; words may follow the numbers.
#pragma once

#include <string_view>

#include "tools/convert/recording.hpp"

namespace perceptor {

/// Reads one line after the other; the header's lines shape the scans that follow.
class TextLog {
 public:
  ParsedLine parse(std::string_view line);

 private:
  ParsedLine parse_header(std::string_view line);
  ParsedLine parse_scan(std::string_view line, bool irregular);

  Position laser_in_robot_;
  double valid_min_ = 0.0;
  double valid_max_ = 0.0;
  bool in_header_ = true;
};

}  // namespace perceptor
