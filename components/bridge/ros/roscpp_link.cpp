/// @file roscpp behind RosLink. Its threads only fill a queue; whatever it calls back is called
/// from take_arrived, on the bridge's own thread.
#include <chrono>
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

/// Between two looks for the master's reply, where there is nothing else to do.
constexpr milliseconds kReplyPause{2};

std::int64_t monotonic_now() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::microseconds>(now).count();
}

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

  /// Takes leave of the master, or goes without where there is none: roscpp would wait for it.
  ~RoscppLink() override {
    if (!is_master_there()) (void)node_.release();
  }

  MasterProbe::Answer ask_master(std::int64_t now) override { return probe_.ask(now); }

  bool subscribe(Feed feed) override {
    if (feed == Feed::laser)
      return subscribe<sensor_msgs::LaserScan>(node().laser, parameters_.laser.topic, feed);
    return subscribe<nav_msgs::Odometry>(node().odometry, parameters_.odometry.topic, feed);
  }

  bool advertise() override {
    const RosCommands& topics = parameters_.commands;
    const bool is_velocity = advertise<geometry_msgs::Twist>(
        node().velocity, topics.velocity,
        [this](const ros::SingleSubscriberPublisher&) { arrived_.velocity_listener = true; });
    return is_velocity && advertise<std_msgs::Empty>(node().open_door, topics.open_door) &&
           advertise<std_msgs::String>(node().speak, topics.speak);
  }

  Arrived take_arrived() override {
    if (node_) node_->callbacks.callAvailable();
    return std::exchange(arrived_, {});
  }

  bool is_alive() const override { return !node_ || ros::ok(); }

  int velocity_listeners() const override {
    return node_ && node_->velocity ? static_cast<int>(node_->velocity.getNumSubscribers()) : 0;
  }

  void drive(double vx, double vy, double va) override {
    geometry_msgs::Twist message;
    message.linear.x = vx;
    message.linear.y = vy;
    message.angular.z = va;
    if (node_ && node_->velocity) node_->velocity.publish(message);
  }

  void open_door() override {
    if (node_ && node_->open_door) node_->open_door.publish(std_msgs::Empty());
  }

  void speak(const std::string& text) override {
    std_msgs::String message;
    message.data = text;
    if (node_ && node_->speak) node_->speak.publish(message);
  }

  void drive_no_more() override {
    for (int i = 0; i < kLastWords && velocity_listeners() > 0; ++i) {
      drive(0.0, 0.0, 0.0);
      std::this_thread::sleep_for(kLastWordsPause);
    }
  }

 private:
  struct Node {
    ros::CallbackQueue callbacks;
    ros::NodeHandle handle;
    ros::Subscriber laser;
    ros::Subscriber odometry;
    ros::Publisher velocity;
    ros::Publisher open_door;
    ros::Publisher speak;
  };

  /// roscpp starts with the first call, and talks to the master then.
  Node& node() {
    if (!node_) {
      node_ = std::make_unique<Node>();
      node_->handle.setCallbackQueue(&node_->callbacks);
    }
    return *node_;
  }

  bool is_master_there() {
    while (true) {
      const MasterProbe::Answer answer = probe_.ask(monotonic_now());
      if (answer != MasterProbe::Answer::not_yet) return answer == MasterProbe::Answer::yes;
      std::this_thread::sleep_for(kReplyPause);
    }
  }

  template <class RosType>
  bool subscribe(ros::Subscriber& subscriber, const std::string& topic, Feed feed) {
    subscriber.shutdown();
    const boost::function<void(const boost::shared_ptr<const Raw<RosType>>&)> take =
        [this, feed](const boost::shared_ptr<const Raw<RosType>>& raw) {
          arrived_.messages.push_back({feed, raw->bytes});
        };
    subscriber = node().handle.subscribe<Raw<RosType>>(topic, kReceiveQueue, take, {},
                                                       ros::TransportHints().tcpNoDelay());
    return static_cast<bool>(subscriber);
  }

  template <class RosType>
  bool advertise(ros::Publisher& publisher, const std::string& topic,
                 const ros::SubscriberStatusCallback& on_listener = {}) {
    if (publisher && publisher.getNumSubscribers() > 0) return true;
    publisher.shutdown();
    publisher = node().handle.advertise<RosType>(topic, kSendQueue, on_listener);
    return static_cast<bool>(publisher);
  }

  RosParameters parameters_;
  MasterProbe probe_;
  Arrived arrived_;
  std::unique_ptr<Node> node_;  ///< none until the master has answered
};

}  // namespace

std::unique_ptr<RosLink> make_ros_link(const RosParameters& parameters, const std::string& master) {
  return std::make_unique<RoscppLink>(parameters, master);
}

}  // namespace perceptor
