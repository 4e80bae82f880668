/// @file roscpp behind RosLink. Its threads only fill a queue; whatever it calls back is called
/// from take_arrived, on the bridge's own thread.
#include <chrono>
#include <optional>
#include <thread>
#include <utility>

#include <geometry_msgs/Twist.h>
#include <nav_msgs/Odometry.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>
#include <std_msgs/Empty.h>
#include <std_msgs/String.h>

#include "components/bridge/ros/ros_link.hpp"

namespace perceptor {
namespace {

/// A message of a ROS type, as the bytes that came.
template <class RosType>
struct Raw {
  std::vector<std::uint8_t> bytes;
};

}  // namespace
}  // namespace perceptor

// What roscpp asks of a type: to publishers, Raw is the type itself.
namespace ros {
namespace message_traits {
template <class RosType>
struct MD5Sum<perceptor::Raw<RosType>> : MD5Sum<RosType> {
  static const char* value() { return MD5Sum<RosType>::value(); }
};
template <class RosType>
struct DataType<perceptor::Raw<RosType>> : DataType<RosType> {
  static const char* value() { return DataType<RosType>::value(); }
};
template <class RosType>
struct Definition<perceptor::Raw<RosType>> : Definition<RosType> {
  static const char* value() { return Definition<RosType>::value(); }
};
}  // namespace message_traits
namespace serialization {
template <class RosType>
struct Serializer<perceptor::Raw<RosType>> {
  template <class Stream>
  static void read(Stream& stream, perceptor::Raw<RosType>& raw) {
    raw.bytes.assign(stream.getData(), stream.getData() + stream.getLength());
  }
};
}  // namespace serialization
}  // namespace ros

namespace perceptor {
namespace {

using std::chrono::milliseconds;

/// Messages that may wait for the next step: some seconds of them. A full queue loses the oldest.
constexpr std::uint32_t kReceiveQueue = 200;
/// Commands that may wait for a slow connection: what is old is of no use.
constexpr std::uint32_t kSendQueue = 5;

/// [s] A call to a master that went away meanwhile ends after this.
constexpr double kMasterPatience = 1.0;

/// roscpp sends in the background. So long, and so often, zero is said at the end.
constexpr milliseconds kLastWordsPause{20};
constexpr int kLastWords = 8;

class RoscppLink : public RosLink {
 public:
  RoscppLink(const RosParameters& parameters, const std::string& master)
      : parameters_(parameters), probe_(parse_master_uri(master).value(), parameters.node) {
    ros::init(ros::M_string{{"__master", master}}, parameters.node,
              ros::init_options::NoSigintHandler | ros::init_options::NoRosout);
    ros::master::setRetryTimeout(ros::WallDuration(kMasterPatience));
  }

  MasterProbe::Answer ask_master(std::int64_t now) override { return probe_.ask(now); }

  bool subscribe(Feed feed) override {
    if (feed == Feed::laser)
      return subscribe<sensor_msgs::LaserScan>(laser_, parameters_.laser.topic, feed);
    return subscribe<nav_msgs::Odometry>(odometry_, parameters_.odometry.topic, feed);
  }

  bool advertise() override {
    const RosCommands& topics = parameters_.commands;
    const bool all = advertise<geometry_msgs::Twist>(
        velocity_, topics.velocity,
        [this](const ros::SingleSubscriberPublisher&) { arrived_.velocity_listener = true; });
    return advertise<std_msgs::Empty>(open_door_, topics.open_door) &&
           advertise<std_msgs::String>(speak_, topics.speak) && all;
  }

  Arrived take_arrived() override {
    callbacks_.callAvailable();
    return std::exchange(arrived_, {});
  }

  bool is_alive() const override { return !node_ || ros::ok(); }

  int velocity_listeners() const override {
    return velocity_ ? static_cast<int>(velocity_.getNumSubscribers()) : 0;
  }

  void drive(double vx, double vy, double va) override {
    if (!velocity_) return;
    geometry_msgs::Twist message;
    message.linear.x = vx;
    message.linear.y = vy;
    message.angular.z = va;
    velocity_.publish(message);
  }

  void open_door() override {
    if (open_door_) open_door_.publish(std_msgs::Empty());
  }

  void speak(const std::string& text) override {
    if (!speak_) return;
    std_msgs::String message;
    message.data = text;
    speak_.publish(message);
  }

  void drive_no_more() override {
    for (int i = 0; i < kLastWords && velocity_listeners() > 0; ++i) {
      drive(0.0, 0.0, 0.0);
      std::this_thread::sleep_for(kLastWordsPause);
    }
  }

 private:
  /// roscpp starts with the first of these, and talks to the master then.
  ros::NodeHandle& node() {
    if (!node_) {
      node_.emplace();
      node_->setCallbackQueue(&callbacks_);
    }
    return *node_;
  }

  template <class RosType>
  bool subscribe(ros::Subscriber& subscriber, const std::string& topic, Feed feed) {
    subscriber.shutdown();
    const boost::function<void(const boost::shared_ptr<const Raw<RosType>>&)> take =
        [this, feed](const boost::shared_ptr<const Raw<RosType>>& raw) {
          arrived_.messages.push_back({feed, raw->bytes});
        };
    subscriber = node().subscribe<Raw<RosType>>(topic, kReceiveQueue, take, {},
                                                ros::TransportHints().tcpNoDelay());
    return static_cast<bool>(subscriber);
  }

  template <class RosType>
  bool advertise(ros::Publisher& publisher, const std::string& topic,
                 const ros::SubscriberStatusCallback& on_listener = {}) {
    if (publisher && publisher.getNumSubscribers() > 0) return true;
    publisher.shutdown();
    publisher = node().advertise<RosType>(topic, kSendQueue, on_listener);
    return static_cast<bool>(publisher);
  }

  RosParameters parameters_;
  MasterProbe probe_;
  ros::CallbackQueue callbacks_;
  Arrived arrived_;
  std::optional<ros::NodeHandle> node_;
  ros::Subscriber laser_;
  ros::Subscriber odometry_;
  ros::Publisher velocity_;
  ros::Publisher open_door_;
  ros::Publisher speak_;
};

}  // namespace

std::unique_ptr<RosLink> make_ros_link(const RosParameters& parameters, const std::string& master) {
  return std::make_unique<RoscppLink>(parameters, master);
}

}  // namespace perceptor
