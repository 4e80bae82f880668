/// @file Where a robot's messages are in ROS 1, and what they mean. The defaults are PICO's.
#pragma once

#include <string>

#include "common/ros1/valid_range.hpp"

namespace perceptor {

struct RosLaser {
  std::string topic = "/pico/laser";     ///< sensor_msgs/LaserScan
  std::string frame;                     ///< frame_id that is taken ("pico/laser"); empty: any
  double miss_noise = ros1::kMissNoise;  ///< [m] "no return" is 0 or range_max, give or take this
  double valid_min = 0.0;                ///< [m] instead of range_min; 0: as the messages say
  double valid_max = 0.0;                ///< [m] instead of range_max; 0: as the messages say
};

struct RosOdometry {
  std::string topic = "/pico/odom";  ///< nav_msgs/Odometry
  std::string frame;                 ///< frame_id that is taken; empty: any
};

struct RosCommands {
  std::string velocity = "/pico/cmd_vel";     ///< geometry_msgs/Twist
  std::string open_door = "/pico/open_door";  ///< std_msgs/Empty
  std::string speak = "/pico/speak";          ///< std_msgs/String
  /// [s] An older command stops the robot. The robot is to have that 0.3 s after the last command,
  /// the way there included.
  double lifetime = 0.28;
};

struct RosParameters {
  std::string master;                ///< "http://HOST:PORT"; empty: as ROS_MASTER_URI says
  std::string node = "pico_bridge";  ///< our name: ROS ends an older node of the same name
  double stale_after = 1.0;          ///< [s] of silence; then a topic is subscribed to anew
  RosLaser laser;
  RosOdometry odometry;
  RosCommands commands;
};

}  // namespace perceptor
