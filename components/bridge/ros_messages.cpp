#include "components/bridge/ros_messages.hpp"

#include "common/messages/convert.hpp"

namespace perceptor {

pico::laser_scan_t to_message(const ros1::LaserScan& scan, const RosLaser& laser,
                              const LaserMounting& mounting) {
  const ros1::ValidRange valid =
      ros1::valid_range(scan.range_min, scan.range_max, laser.miss_noise);
  pico::laser_scan_t message{};
  message.laser_in_robot = to_message(mounting.laser_in_robot);
  message.time_increment = scan.time_increment;
  message.angle_min = scan.angle_min;
  message.angle_max = ros1::last_angle(scan).value_or(scan.angle_max);
  message.angle_increment = scan.angle_increment;
  message.valid_min = laser.valid_min > 0.0 ? laser.valid_min : valid.min;
  message.valid_max = laser.valid_max > 0.0 ? laser.valid_max : valid.max;
  message.range_sigma = mounting.range_sigma;
  message.num_ranges = static_cast<std::int32_t>(scan.ranges.size());
  message.ranges = scan.ranges;
  return message;
}

pico::odometry_t to_message(const ros1::Odometry& odometry) {
  pico::odometry_t message{};
  message.robot_in_odometry = to_message(odometry.pose);
  return message;
}

}  // namespace perceptor
