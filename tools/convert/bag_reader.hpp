/// @file The laser and the odometry of a ROS bag.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "common/ros1/valid_range.hpp"
#include "tools/convert/bag_file.hpp"
#include "tools/convert/recording.hpp"

namespace perceptor {

/// What is read of a bag. The defaults are PICO's.
struct BagTopics {
  std::string laser = "/pico/laser";    ///< sensor_msgs/LaserScan
  std::string odometry = "/pico/odom";  ///< nav_msgs/Odometry

  bool is_wanted(std::string_view topic) const { return topic == laser || topic == odometry; }
};

/// Reads forward, a message at a time. Which ranges are returns is said as pico-bridge says it of
/// the same messages.
class BagReader {
 public:
  /// `file` was opened for what `topics` want.
  BagReader(BagFile file, BagTopics topics);

  /// What the next message of these topics gave; none at the end.
  std::optional<ParsedLine> next();

  std::int64_t line() const { return read_; }  ///< messages, up to the one that was given last

  /// Topics that were skipped.
  std::vector<std::string> notes() const;

 private:
  ParsedLine parse(const BagMessage& message) const;

  struct Skipped {
    std::string type;
    std::int64_t count = 0;
  };

  BagFile file_;
  BagTopics topics_;
  std::int64_t read_ = 0;
  std::map<std::string, Skipped> skipped_;  ///< by topic
};

}  // namespace perceptor
