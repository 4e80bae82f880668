/// @file The log format of CARMEN (Carnegie Mellon Robot Navigation Toolkit), version 1:
///
///     ODOM x y theta tv rv accel ipc_timestamp hostname logger_timestamp
///     FLASER n r1 .. rn laser(x y theta) odometry(x y theta) ipc_timestamp ...
///     ROBOTLASER1 type start_angle fov increment range_max accuracy remission_mode
///                 n r1 .. rn m i1 .. im laser(x y theta) robot(x y theta)
///                 tv rv forward_safety side_safety turn_axis ipc_timestamp ...
///
/// Times are the ipc_timestamp. Where a scan's line is the only odometry there is, the
/// robot's pose in it becomes one; once an ODOM line has come, only those count, because the
/// poses of corrected logs are in another frame.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tools/convert/recording.hpp"

namespace perceptor {

class CarmenLog {
 public:
  ParsedLine parse(std::string_view line);

  /// What a person should know of the lines so far.
  std::vector<std::string> notes() const;

 private:
  ParsedLine parse_odometry(std::string_view line);
  ParsedLine parse_front_laser(std::string_view line);
  ParsedLine parse_robot_laser(std::string_view line);
  ParsedLine finish_scan(ScanRecord scan, const Position& laser, const Position& robot);

  bool has_odometry_lines_ = false;
  std::optional<Position> laser_in_robot_;
  std::int64_t other_mountings_ = 0;
};

/// Whether a line begins with a word of a CARMEN log.
bool is_carmen_keyword(std::string_view keyword);

}  // namespace perceptor
