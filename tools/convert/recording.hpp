/// @file What one line of a recording says, whatever the format of its file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "common/geometry/position.hpp"

namespace perceptor {

/// The input is not of a kind that is read; says what it is and what to do.
class NotARecording : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct OdometryRecord {
  std::int64_t utime = 0;  ///< [us]
  Position robot_in_odometry;
};

/// Beam i of a regular scan points at angle_min + i * angle_increment; an irregular one has a
/// bearing for each range.
struct ScanRecord {
  std::int64_t utime = 0;  ///< [us] of the first beam
  Position laser_in_robot;
  double angle_min = 0.0;        ///< [rad] laser frame
  double angle_increment = 0.0;  ///< [rad] counter-clockwise positive
  double time_increment = 0.0;   ///< [s] from beam to beam; 0: not recorded, or all at once
  double range_max = 0.0;        ///< [m] what the laser calls its maximum; 0: not recorded
  double valid_min = 0.0;        ///< [m] shorter is "no return"; 0: not recorded
  double valid_max = 0.0;        ///< [m] longer is "no return"; 0: not recorded
  std::vector<float> ranges;     ///< [m] as recorded
  std::vector<float> bearings;   ///< [rad] laser frame, in recorded order; empty: regular
};

/// Why a line gave nothing. `reason` is one of drop_reason, which is counted; `detail` is what
/// stood there.
struct Dropped {
  std::string_view reason;
  std::string detail;
};

/// What one line gave; the odometry of a line comes before its scan.
struct ParsedLine {
  std::optional<OdometryRecord> odometry;
  std::optional<ScanRecord> scan;
  std::optional<Dropped> dropped;

  bool empty() const { return !odometry && !scan && !dropped; }
};

namespace drop_reason {
inline constexpr std::string_view bad_number = "bad number";
inline constexpr std::string_view bad_time = "time out of range";
inline constexpr std::string_view wrong_count = "wrong count";
inline constexpr std::string_view too_many_beams = "more beams than a message carries";
inline constexpr std::string_view unknown_keyword = "unknown keyword";
inline constexpr std::string_view late_header = "header line after the first record";
inline constexpr std::string_view too_long = "line too long";
inline constexpr std::string_view not_converted = "kind of line that is not converted";
inline constexpr std::string_view no_valid_range = "no valid range (give --valid-max)";
inline constexpr std::string_view wrong_angles = "number of beams does not match the angles";
inline constexpr std::string_view another_type = "another type than is read from its topic";
inline constexpr std::string_view damaged = "damaged";
inline constexpr std::string_view replaced = "odometry replaced by --still";
}  // namespace drop_reason

}  // namespace perceptor
