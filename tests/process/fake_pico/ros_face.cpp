#include "tests/process/fake_pico/ros_face.hpp"

#include <cmath>
#include <utility>

#include <geometry_msgs/Twist.h>
#include <nav_msgs/Odometry.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>
#include <std_msgs/Empty.h>
#include <std_msgs/String.h>

namespace perceptor::test {
namespace {

constexpr std::uint32_t kQueue = 100;

ros::Time time_of(std::int64_t stamp) {
  ros::Time time;
  return time.fromNSec(static_cast<std::uint64_t>(stamp));
}

/// A LaserScan that announces 2^30 ranges and holds none.
struct BrokenScan {};

}  // namespace
}  // namespace perceptor::test

namespace ros {
namespace message_traits {
using perceptor::test::BrokenScan;
template <>
struct MD5Sum<BrokenScan> : MD5Sum<sensor_msgs::LaserScan> {
  static const char* value() { return MD5Sum<sensor_msgs::LaserScan>::value(); }
  static const char* value(const BrokenScan&) { return value(); }
};
template <>
struct DataType<BrokenScan> : DataType<sensor_msgs::LaserScan> {
  static const char* value() { return DataType<sensor_msgs::LaserScan>::value(); }
  static const char* value(const BrokenScan&) { return value(); }
};
template <>
struct Definition<BrokenScan> : Definition<sensor_msgs::LaserScan> {
  static const char* value() { return Definition<sensor_msgs::LaserScan>::value(); }
  static const char* value(const BrokenScan&) { return value(); }
};
}  // namespace message_traits
namespace serialization {
template <>
struct Serializer<perceptor::test::BrokenScan> {
  static constexpr std::uint32_t kNumbers = 7;
  template <class Stream>
  static void write(Stream& stream, const perceptor::test::BrokenScan&) {
    stream.next(std_msgs::Header());
    for (std::uint32_t i = 0; i < kNumbers; ++i) stream.next(0.5F);
    stream.next(std::uint32_t{1} << 30U);
  }
  // NOLINTNEXTLINE(readability-identifier-naming): roscpp asks for this name
  static std::uint32_t serializedLength(const perceptor::test::BrokenScan&) {
    return serializationLength(std_msgs::Header()) + 4 * kNumbers + 4;
  }
};
}  // namespace serialization
}  // namespace ros

namespace perceptor::test {

struct RosFace::Topics {
  ros::NodeHandle node;
  ros::CallbackQueue callbacks;
  ros::Publisher laser = node.advertise<sensor_msgs::LaserScan>("/pico/laser", kQueue);
  ros::Publisher broken = node.advertise<BrokenScan>("/pico/laser", kQueue);
  ros::Publisher odometry = node.advertise<nav_msgs::Odometry>("/pico/odom", kQueue);
  ros::Subscriber velocity;
  ros::Subscriber open_door;
  ros::Subscriber speak;
  Heard heard;

  Topics() {
    node.setCallbackQueue(&callbacks);
    const boost::function<void(const geometry_msgs::Twist&)> hear_velocity =
        [this](const geometry_msgs::Twist& twist) {
          heard.velocities.push_back({twist.linear.x, twist.linear.y, twist.angular.z});
        };
    const boost::function<void(const std_msgs::Empty&)> hear_open_door =
        [this](const std_msgs::Empty&) { ++heard.open_door; };
    const boost::function<void(const std_msgs::String&)> hear_speak =
        [this](const std_msgs::String& speech) { heard.spoken.push_back(speech.data); };
    velocity = node.subscribe<geometry_msgs::Twist>("/pico/cmd_vel", kQueue, hear_velocity);
    open_door = node.subscribe<std_msgs::Empty>("/pico/open_door", kQueue, hear_open_door);
    speak = node.subscribe<std_msgs::String>("/pico/speak", kQueue, hear_speak);
  }
};

RosFace::RosFace() {
  ros::init(ros::M_string{}, "pico", ros::init_options::NoSigintHandler);
  topics_ = std::make_unique<Topics>();
}

RosFace::~RosFace() = default;

void RosFace::publish(const Scan& scan) {
  sensor_msgs::LaserScan message;
  message.header.stamp = time_of(scan.stamp);
  message.header.frame_id = "pico/laser";
  message.angle_min = static_cast<float>(scan.angle_min);
  message.angle_max = static_cast<float>(scan.angle_max);
  message.angle_increment = static_cast<float>(scan.angle_increment);
  message.time_increment = static_cast<float>(scan.time_increment);
  message.range_min = static_cast<float>(scan.range_min);
  message.range_max = static_cast<float>(scan.range_max);
  message.ranges = scan.ranges;
  message.intensities.assign(scan.ranges.size(), 100.0F);
  topics_->laser.publish(message);
}

void RosFace::publish(const Odometry& odometry) {
  nav_msgs::Odometry message;
  message.header.stamp = time_of(odometry.stamp);
  message.header.frame_id = "pico/odom";
  message.child_frame_id = "pico/base_link";
  message.pose.pose.position.x = odometry.x;
  message.pose.pose.position.y = odometry.y;
  message.pose.pose.orientation.z = std::sin(0.5 * odometry.a);
  message.pose.pose.orientation.w = std::cos(0.5 * odometry.a);
  topics_->odometry.publish(message);
}

void RosFace::publish_broken_scan() { topics_->broken.publish(BrokenScan()); }

bool RosFace::is_listened_to() const {
  return topics_->laser.getNumSubscribers() > 0 && topics_->odometry.getNumSubscribers() > 0;
}

RosFace::Heard RosFace::take_heard() {
  topics_->callbacks.callAvailable();
  return std::exchange(topics_->heard, {});
}

}  // namespace perceptor::test
