/// @file A robot that speaks ROS 1 as a source: its measurements are checked and published, and
/// commands go to it.
///
/// Whatever goes away is waited for and comes back by itself: no master, a master that was
/// restarted, a robot that was. What has been silent for a while is subscribed to anew, and what
/// nobody listens to is advertised anew, once the master answers; what works is left alone, because
/// a robot that outlived its master is known to nobody but us.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "common/bus/bus.hpp"
#include "common/ros1/ros1_messages.hpp"
#include "common/time/continuity.hpp"
#include "components/bridge/bridge_config.hpp"
#include "components/bridge/ros/robot_clock.hpp"
#include "components/bridge/ros/ros_link.hpp"
#include "components/bridge/ros/velocity_output.hpp"
#include "components/bridge/source.hpp"

namespace perceptor {

class RosSource : public Source {
 public:
  /// `session` numbers what is published. Throws config::Error for what only a simulator can do.
  RosSource(const BridgeConfig& config, std::int64_t session, Bus& bus,
            std::unique_ptr<RosLink> link);
  ~RosSource() override { RosSource::stop(); }

  std::int64_t step(std::int64_t now) override;
  bool finished() const override;
  void stop() override;

 private:
  /// One kind of measurement on its way from ROS to the bus.
  struct Feed {
    std::string topic;
    std::string frame;    ///< that is taken; empty: any
    const char* channel;  ///< where it goes
    bool is_subscribed = false;
    std::int64_t subscribed_at = 0;  ///< [us]
    std::int64_t heard_at = 0;       ///< [us] when the last message came
    ContinuityWatch watch = {};
    std::int64_t published = 0;
  };

  Feed& feed(RosLink::Feed which);
  void take(const RosLink::Arrived::Message& message);
  template <class RosMessage>
  void publish(Feed& feed, ros1::Bytes bytes, const auto& convert);
  void drive(const Twist& wished, std::optional<std::int64_t> measured_at);
  bool is_silent(const Feed& feed) const;
  bool needs_subscription(const Feed& feed) const;
  void keep_connected();
  bool connect_what_is_silent();
  void say_how_it_goes();

  Bus& bus_;
  std::int64_t session_;
  std::int64_t duration_;  ///< [us]; 0: for ever
  RosParameters ros_;
  LaserMounting mounting_;
  std::unique_ptr<RosLink> link_;
  Feed laser_;
  Feed odometry_;
  RobotClock robot_clock_;
  VelocityOutput velocity_;
  std::int64_t started_ = 0;  ///< [us, monotonic] of the first step; 0: none yet
  std::int64_t now_ = 0;      ///< [us, monotonic] of the last step
  std::int64_t next_question_ = 0;
  std::int64_t next_note_ = 0;
  bool does_master_answer_ = true;  ///< when it was last asked
  bool is_advertised_ = false;      ///< the master knows what we publish
  bool is_stopped_ = false;
};

}  // namespace perceptor
