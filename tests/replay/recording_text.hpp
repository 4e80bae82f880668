/// @file A recording's text, read apart from pico-convert: what the processes should count.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace perceptor::test {

struct TextScan {
  double time = 0.0;  ///< [s]
  std::int64_t beams_without_return = 0;
};

struct TextRecording {
  std::vector<TextScan> scans;  ///< in the order of the file: the place is the scan's seq
  double first_odometry = 0.0;  ///< [s] 0 where none was recorded
  double last_odometry = 0.0;   ///< [s]
};

/// Reads LASER, LASERA and ODOM lines. A range is no return where it is not finite or outside
/// the header's valid_min and valid_max, as the 32 bits that a message carries.
TextRecording read_text(const std::string& text);

}  // namespace perceptor::test
