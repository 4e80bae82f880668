/// What a robot sends in ROS 1.
#include "common/ros1/ros1_messages.hpp"
#include "tests/fuzz/target.hpp"
#include "tests/support/ros1_bytes.hpp"

namespace perceptor::fuzz {

std::vector<Bytes> seeds() {
  return {testing::bytes_of(testing::Ros1Scan{}), testing::bytes_of(testing::Ros1Odometry{})};
}

}  // namespace perceptor::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace perceptor;
  const ros1::Bytes bytes(data, size);
  ros1::LaserScan scan;
  if (ros1::decode(bytes, scan).empty())
    fuzz::require(scan.ranges.size() * sizeof(float) <= size, "as many ranges as there are bytes");
  ros1::Odometry odometry;
  if (ros1::decode(bytes, odometry).empty())
    fuzz::require(odometry.pose.a >= -4.0 && odometry.pose.a <= 4.0, "a heading is an angle");
  return 0;
}
