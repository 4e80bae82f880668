/// @file What can be configured of a robot that speaks ROS 1.
#pragma once

#include <string>

#include "common/config/fields.hpp"
#include "components/bridge/ros/ros_parameters.hpp"

namespace perceptor {

void describe(config::Fields& fields, RosLaser& laser);
void describe(config::Fields& fields, RosOdometry& odometry);
void describe(config::Fields& fields, RosCommands& commands);
void describe(config::Fields& fields, RosParameters& ros);

/// Where the master is: as configured, else ROS_MASTER_URI, else ROS's own default on this machine.
std::string master_uri(const RosParameters& ros);

}  // namespace perceptor
