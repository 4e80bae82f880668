/// @file ROS 1 messages as they travel, written apart from the code that reads them.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace perceptor::testing {

class Ros1Bytes {
 public:
  template <class Number>
  Ros1Bytes& add(Number number) {
    const auto* from = reinterpret_cast<const std::uint8_t*>(&number);
    bytes_.insert(bytes_.end(), from, from + sizeof(number));
    return *this;
  }
  Ros1Bytes& text(const std::string& text) {
    add(static_cast<std::uint32_t>(text.size()));
    bytes_.insert(bytes_.end(), text.begin(), text.end());
    return *this;
  }
  Ros1Bytes& floats(const std::vector<float>& values) {
    add(static_cast<std::uint32_t>(values.size()));
    for (const float value : values) add(value);
    return *this;
  }
  Ros1Bytes& header(std::uint32_t seq, std::uint32_t seconds, std::uint32_t nanoseconds,
                    const std::string& frame) {
    return add(seq).add(seconds).add(nanoseconds).text(frame);
  }

  const std::vector<std::uint8_t>& bytes() const { return bytes_; }

 private:
  std::vector<std::uint8_t> bytes_;
};

struct Ros1Scan {
  std::uint32_t seq = 7;
  std::uint32_t seconds = 100;
  std::uint32_t nanoseconds = 0;
  std::string frame = "pico/laser";
  float angle_min = -1.0F;
  float angle_max = 1.0F;
  float angle_increment = 1.0F;
  float time_increment = 1e-5F;
  float range_min = 0.01F;
  float range_max = 10.0F;
  std::vector<float> ranges = {1.0F, 2.0F, 3.0F};
  std::vector<float> intensities;
};

inline std::vector<std::uint8_t> bytes_of(const Ros1Scan& scan) {
  const float scan_time = 0.025F;
  return Ros1Bytes()
      .header(scan.seq, scan.seconds, scan.nanoseconds, scan.frame)
      .add(scan.angle_min)
      .add(scan.angle_max)
      .add(scan.angle_increment)
      .add(scan.time_increment)
      .add(scan_time)
      .add(scan.range_min)
      .add(scan.range_max)
      .floats(scan.ranges)
      .floats(scan.intensities)
      .bytes();
}

struct Ros1Odometry {
  std::uint32_t seq = 7;
  std::uint32_t seconds = 100;
  std::uint32_t nanoseconds = 0;
  std::string frame = "pico/odom";
  double x = 1.5;
  double y = -2.5;
  double qx = 0.0;
  double qy = 0.0;
  double qz = std::sin(0.25);
  double qw = std::cos(0.25);
};

inline std::vector<std::uint8_t> bytes_of(const Ros1Odometry& odometry) {
  const double height = 0.3;
  Ros1Bytes bytes;
  bytes.header(odometry.seq, odometry.seconds, odometry.nanoseconds, odometry.frame)
      .text("pico/base_link");
  for (const double number :
       {odometry.x, odometry.y, height, odometry.qx, odometry.qy, odometry.qz, odometry.qw})
    bytes.add(number);
  for (int i = 0; i < 36 + 6 + 36; ++i) bytes.add(0.0);
  return bytes.bytes();
}

}  // namespace perceptor::testing
