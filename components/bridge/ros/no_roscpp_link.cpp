/// @file In the place of roscpp_link.cpp in a build without ROS 1.
#include "components/bridge/ros/ros_link.hpp"

namespace perceptor {

std::unique_ptr<RosLink> make_ros_link(const RosParameters&, const std::string&) { return nullptr; }

}  // namespace perceptor
