#include "components/bridge/ros_source.hpp"

#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "common/bus/channels.hpp"
#include "components/bridge/driver_commands.hpp"
#include "components/bridge/ros_messages.hpp"

namespace perceptor {
namespace {

/// [us] Messages wait so long at most until they are looked for.
constexpr std::int64_t kStep = 2'000;

/// [us] Between a master's no and the next question.
constexpr std::int64_t kPause = 500'000;

/// [us] Between two looks at how it goes.
constexpr std::int64_t kNotePeriod = 200'000;

}  // namespace

RosSource::RosSource(const BridgeConfig& config, std::int64_t session, Bus& bus,
                     std::unique_ptr<RosLink> link)
    : bus_(bus),
      session_(session),
      duration_(static_cast<std::int64_t>(std::llround(config.duration * 1e6))),
      ros_(config.ros),
      mounting_(config.robot.laser),
      link_(std::move(link)),
      laser_{ros_.laser.topic, ros_.laser.frame, channel::laser},
      odometry_{ros_.odometry.topic, ros_.odometry.frame, channel::odometry},
      velocity_(config.robot.limits, ros_.commands.lifetime) {
  if (config.speed != 1.0) throw config::Error("/speed: a real robot's time goes at speed 1");
  for (const Feed& feed : {laser_, odometry_}) bus_.status().add_input(feed.topic);
  subscribe(bus, session,
            {[this](const Twist& wished, std::optional<std::int64_t> measured_at) {
               drive(wished, measured_at);
             },
             [this](std::optional<int>) { link_->open_door(); },
             [this](const std::string& text) { link_->speak(text); }});
}

bool RosSource::finished() const { return duration_ > 0 && now_ - started_ >= duration_; }

std::int64_t RosSource::step(std::int64_t now) {
  if (started_ == 0) started_ = now;
  now_ = now;
  if (!link_->is_alive())
    throw std::runtime_error("ROS has shut down this node: has another one with the name /" +
                             ros_.node + " been started, or was it told to by rosnode kill?");
  const RosLink::Arrived arrived = link_->take_arrived();
  for (const auto& message : arrived.messages) take(message);
  if (arrived.velocity_listener) velocity_.heard_by_another(now);
  keep_connected();
  if (const auto twist = velocity_.due(now)) link_->drive(twist->vx, twist->vy, twist->va);
  if (now >= next_note_) say_how_it_goes();
  return now + kStep;
}

void RosSource::stop() {
  if (!std::exchange(is_stopped_, true)) link_->drive_no_more();
}

RosSource::Feed& RosSource::feed(RosLink::Feed which) {
  return which == RosLink::Feed::laser ? laser_ : odometry_;
}

void RosSource::take(const RosLink::Arrived::Message& message) {
  if (message.feed == RosLink::Feed::laser)
    publish<ros1::LaserScan>(laser_, message.bytes, [this](const ros1::LaserScan& scan) {
      return to_message(scan, ros_.laser, mounting_);
    });
  else
    publish<ros1::Odometry>(odometry_, message.bytes,
                            [](const ros1::Odometry& odometry) { return to_message(odometry); });
}

/// Checked as every message that comes in over the bus: its bytes, its sense, its time.
template <class RosMessage>
void RosSource::publish(Feed& feed, ros1::Bytes bytes, const auto& convert) {
  feed.heard_at = now_;
  bus_.status().received(feed.topic);
  RosMessage received;
  if (const auto fault = ros1::decode(bytes, received); !fault.empty())
    return bus_.reject(feed.topic, fault);
  const ros1::Header& header = received.header;
  if (!feed.frame.empty() && !ros1::is_same_frame(feed.frame, header.frame))
    return bus_.reject(feed.topic, "of another frame");
  auto message = convert(received);
  set_stamp(message, {header.utime, session_, feed.published});
  if (const auto fault = messages::validate(message); !fault.empty())
    return bus_.reject(feed.topic, fault);
  const Stamp stamp_in_ros{header.utime, session_, header.seq};
  const Continuity continuity = feed.watch.check(stamp_in_ros);
  bus_.status().watched(feed.topic, feed.watch);
  if (const auto fault = order_fault(continuity); !fault.empty())
    return bus_.reject(feed.topic, fault);
  bus_.status().accepted(feed.topic, stamp_in_ros);
  robot_clock_.saw(header.utime, now_);
  ++feed.published;
  bus_.publish(feed.channel, message);
}

void RosSource::drive(const Twist& wished, std::optional<std::int64_t> measured_at) {
  const std::int64_t since = measured_at ? robot_clock_.arrival(*measured_at, now_) : now_;
  if (velocity_.wish(wished, since, now_))
    bus_.count(channel::velocity, "limited to what the robot may drive", 1);
}

bool RosSource::is_silent(const Feed& feed) const {
  return seconds_between(feed.heard_at, now_) > ros_.stale_after;
}

/// Anew, where the last one has brought nothing for so long.
bool RosSource::needs_subscription(const Feed& feed) const {
  const bool had_its_time = seconds_between(feed.subscribed_at, now_) > ros_.stale_after;
  return !feed.is_subscribed || (is_silent(feed) && had_its_time);
}

void RosSource::keep_connected() {
  const bool is_all_well =
      is_advertised_ && !needs_subscription(laser_) && !needs_subscription(odometry_);
  if (is_all_well || now_ < next_question_) return;
  const MasterProbe::Answer answer = link_->ask_master(now_);
  if (answer == MasterProbe::Answer::not_yet) return;
  does_master_answer_ = answer == MasterProbe::Answer::yes && connect_what_is_silent();
  if (!does_master_answer_) next_question_ = now_ + kPause;
  next_note_ = now_;
}

/// Gives whether the master took it all.
bool RosSource::connect_what_is_silent() {
  is_advertised_ = link_->advertise();
  bool taken = is_advertised_;
  for (const RosLink::Feed which : {RosLink::Feed::laser, RosLink::Feed::odometry}) {
    Feed& silent = feed(which);
    if (!needs_subscription(silent)) continue;
    silent.is_subscribed = link_->subscribe(which);
    silent.subscribed_at = now_;
    taken = taken && silent.is_subscribed;
  }
  return taken;
}

void RosSource::say_how_it_goes() {
  next_note_ = now_ + kNotePeriod;
  std::string note = "ROS master " + master_uri(ros_);
  if (!does_master_answer_) note += " does not answer: is the robot on, and is that its address?";
  for (const Feed* each : {&laser_, &odometry_})
    if (each->published > 0 && is_silent(*each)) note += ", nothing on " + each->topic;
  const bool is_connected = laser_.is_subscribed || odometry_.is_subscribed;
  if (is_connected && link_->velocity_listeners() == 0)
    note += ", nobody listens to " + ros_.commands.velocity;
  bus_.status().set_note(note);
}

}  // namespace perceptor
