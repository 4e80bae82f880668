/// @file What a robot says in ROS 1, as messages of ours. Stamps are the caller's.
#pragma once

#include <pico/laser_scan_t.hpp>
#include <pico/odometry_t.hpp>

#include "common/config/robot.hpp"
#include "common/ros1/ros1_messages.hpp"
#include "components/bridge/ros/ros_parameters.hpp"

namespace perceptor {

/// Ranges and angles as they are. What a LaserScan does not say (where the laser is mounted, its
/// noise) is the robot's; which ranges are returns follows from its range_min and range_max, unless
/// `laser` says otherwise.
pico::laser_scan_t to_message(const ros1::LaserScan& scan, const RosLaser& laser,
                              const LaserMounting& mounting);

pico::odometry_t to_message(const ros1::Odometry& odometry);

}  // namespace perceptor
