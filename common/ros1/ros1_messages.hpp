/// @file The two ROS 1 messages that a robot's measurements come in, read from their bytes as they
/// travel over TCPROS and lie in bags. Nothing of ROS is needed for it.
///
/// The wire format: fields in their order, little-endian, without gaps; texts and arrays begin with
/// their length as an uint32. ROS's own reader believes each length and allocates for it first: a
/// message of 60 bytes that announces 2^30 ranges costs 4 GB. Here nothing is believed.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "common/geometry/position.hpp"

namespace perceptor::ros1 {

using Bytes = std::span<const std::uint8_t>;

/// std_msgs/Header
struct Header {
  std::uint32_t seq = 0;   ///< counted by whoever publishes the topic
  std::int64_t utime = 0;  ///< [us] the stamp, rounded from nanoseconds
  std::string frame;       ///< frame_id
};

/// sensor_msgs/LaserScan, without its intensities. Beam i points at
/// angle_min + i * angle_increment.
struct LaserScan {
  Header header;                 ///< its utime is that of the first beam
  float angle_min = 0.0F;        ///< [rad] laser frame
  float angle_max = 0.0F;        ///< [rad]
  float angle_increment = 0.0F;  ///< [rad]
  float time_increment = 0.0F;   ///< [s] from beam to beam
  float range_min = 0.0F;        ///< [m]
  float range_max = 0.0F;        ///< [m]
  std::vector<float> ranges;     ///< [m] as measured
};

/// nav_msgs/Odometry, without its twist and covariances, which PICO leaves at zero.
struct Odometry {
  Header header;
  Position pose;  ///< of the robot in the frame of the header; the heading from the quaternion
};

/// Why the bytes are no such message; empty: `scan` holds it. Numbers are as they were sent, NaN
/// included: whether they make sense is asked of the message of ours that they become.
std::string_view decode(Bytes bytes, LaserScan& scan);

/// The same. A quaternion that is no rotation is a fault; a tilted robot has the heading of its
/// x axis, seen from above.
std::string_view decode(Bytes bytes, Odometry& odometry);

/// The angle of the last beam [rad]. Some drivers say an angle_max that is one beam off: that is
/// forgiven; none where it is farther off.
std::optional<double> last_angle(const LaserScan& scan);

/// Whether two names are of one frame: a leading slash counts for nothing.
bool is_same_frame(std::string_view one, std::string_view other);

}  // namespace perceptor::ros1
