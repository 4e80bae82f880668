/// @file What the bridge needs of ROS 1. Behind it is roscpp, or in tests nothing. C++17 here and
/// in what is included: ROS's headers need what C++20 took out of std::allocator.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "components/bridge/ros/master_probe.hpp"
#include "components/bridge/ros/ros_parameters.hpp"

namespace perceptor {

class RosLink {
 public:
  enum class Feed { laser, odometry };

  /// What came since it was last asked.
  struct Arrived {
    struct Message {
      Feed feed;
      std::vector<std::uint8_t> bytes;  ///< as sent: see common/ros1
    };
    std::vector<Message> messages;   ///< in order of arrival
    bool velocity_listener = false;  ///< somebody new listens to velocities
  };

  RosLink() = default;
  RosLink(const RosLink&) = delete;
  RosLink& operator=(const RosLink&) = delete;
  virtual ~RosLink() = default;

  /// Whether the master answers; never waits.
  virtual MasterProbe::Answer ask_master(std::int64_t now) = 0;

  /// Subscribes anew. Only right after the master has answered. False: the master did not take it.
  virtual bool subscribe(Feed feed) = 0;

  /// Makes the publishers anew that nobody listens to. Only right after the master has answered.
  virtual bool advertise() = 0;

  virtual Arrived take_arrived() = 0;

  /// False: ROS has shut this node down, for good.
  virtual bool is_alive() const = 0;

  /// Who listens to velocities.
  virtual int velocity_listeners() const = 0;

  virtual void drive(double vx, double vy, double va) = 0;  ///< [m/s] [m/s] [rad/s]
  virtual void open_door() = 0;
  virtual void speak(const std::string& text) = 0;

  /// Velocity zero, and time for it to get there: the program is about to end.
  virtual void drive_no_more() = 0;
};

/// The one behind which there is roscpp, none in a build without it. `master` is
/// "http://HOST:PORT".
std::unique_ptr<RosLink> make_ros_link(const RosParameters& parameters, const std::string& master);

}  // namespace perceptor
