/// @file A ROS bag, message by message, without a master. The only place that knows rosbag_storage
/// is behind it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace perceptor {

struct BagMessage {
  std::string topic;
  std::string type;                 ///< "sensor_msgs/LaserScan"
  std::vector<std::uint8_t> bytes;  ///< as sent: see common/ros1; none where it is not wanted
  std::string fault;                ///< why it cannot be read; empty: it can
};

struct BagFile {
  std::int64_t messages = 0;  ///< in all
  /// The next one, in the order in which they were recorded; none at the end.
  std::function<std::optional<BagMessage>()> next;
};

/// Whether a file begins as a bag does, whatever its name; false where it cannot be read.
bool is_bag(const std::filesystem::path& file);

/// Only of topics that are wanted the bytes are read. Throws NotARecording: damaged, without an
/// index, or in a build without rosbag_storage.
BagFile open_bag(const std::filesystem::path& file,
                 const std::function<bool(std::string_view topic)>& is_wanted);

}  // namespace perceptor
