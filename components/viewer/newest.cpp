#include "components/viewer/newest.hpp"

#include <utility>

#include "common/bus/channels.hpp"
#include "common/messages/convert.hpp"
#include "common/time/stamp.hpp"

namespace perceptor::viewer {

/// GLOBAL_MAP has a session and a time of its own.
template <class Message>
void Newest::hear(const std::string& channel, const Message& message) {
  const bool is_of_the_robot = channel != channel::global_map;
  if (is_of_the_robot && !clock_.take(channel, message.utime, message.session)) begin_anew();
}

/// Nothing of before is where it was, but the building.
void Newest::begin_anew() {
  auto building = maps_.extract(channel::global_map);
  const ChannelClock clock = clock_;
  *this = Newest(parameters_);
  clock_ = clock;
  if (!building.empty()) maps_.insert(std::move(building));
}

/// Another zero frame is another beginning, and POSITION has the say about it; what is still of the
/// one before is not.
bool Newest::is_of_this_zero(std::int64_t zero_utime) {
  const bool is_this = !zero_utime_ || *zero_utime_ == zero_utime;
  if (!is_this && position_) return false;
  if (!is_this) begin_anew();
  zero_utime_ = zero_utime;
  return true;
}

void Newest::take(const pico::laser_scan_t& scan) {
  hear(channel::laser, scan);
  scan_ = scan;
}

void Newest::take(const pico::position_t& position) {
  hear(channel::position, position);
  if (zero_utime_ && *zero_utime_ != position.zero_utime) begin_anew();
  zero_utime_ = position.zero_utime;
  const Position robot_in_zero = to_model(position.robot_in_zero);
  if (position_)
    twist_ = twist_between(to_model(position_->robot_in_zero), robot_in_zero,
                           seconds_between(position_->utime, position.utime));
  position_ = position;
  frames_.take_zero_pose(position.utime, robot_in_zero);
  extend_trail();
}

void Newest::take(const pico::proximity_t& proximity) {
  hear(channel::proximity, proximity);
  proximity_ = proximity;
}

void Newest::take(const pico::entrance_t& entrance) {
  hear(channel::entrance, entrance);
  entrance_ = entrance;
}

void Newest::take(const pico::world_position_t& position) {
  hear(channel::world_position, position);
  world_position_ = position;
  const bool is_known = position.state == pico::world_position_t::TRACKING;
  frames_.take_world_pose(
      position.utime, is_known ? std::optional(to_model(position.robot_in_world)) : std::nullopt);
}

void Newest::take(const pico::truth_t& truth) {
  hear(channel::truth, truth);
  truth_ = truth;
  frames_.take_true_pose(truth.utime, to_model(truth.robot_in_world));
}

void Newest::take(const std::string& channel, const pico::map_t& map) {
  hear(channel, map);
  const bool is_local = channel == channel::local_map;
  if (is_local && !is_of_this_zero(map.zero_utime)) return;
  keep(channel, map);
  if (!is_local) return;
  frames_.take_local_pose(map.utime, to_model(map.robot_in_zero), to_model(map.robot_in_local));
  extend_trail();
}

void Newest::keep(const std::string& channel, const pico::map_t& map) {
  Parts& known = maps_[channel];
  if (known.map_id != map.map_id || known.count != map.parts) known = {map.map_id, map.parts, {}};
  known.there[map.part] = map;
}

void Newest::extend_trail() {
  const auto robot = frames_.robot_in_local();
  if (!robot) return;
  if (!trail_.empty() && distance(trail_.back(), robot->location()) < parameters_.trail_step)
    return;
  trail_.push_back(robot->location());
  if (trail_.size() > static_cast<std::size_t>(parameters_.trail_points)) trail_.pop_front();
}

}  // namespace perceptor::viewer
