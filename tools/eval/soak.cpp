#include "tools/eval/soak.hpp"

#include <chrono>
#include <map>
#include <utility>
#include <variant>
#include <vector>

#include <pico/map_t.hpp>
#include <pico/status_t.hpp>
#include <pico/world_position_t.hpp>

#include "common/bus/channels.hpp"
#include "common/bus/losses.hpp"
#include "common/geometry/vector2.hpp"
#include "common/messages/convert.hpp"
#include "common/messages/encode.hpp"
#include "common/time/stamp.hpp"
#include "components/bridge/sim_messages.hpp"
#include "tools/eval/quantile.hpp"

namespace perceptor {
namespace {

template <class Message>
Message decoded(Pipeline::Bytes payload) {
  Message message;
  message.decode(payload.data(), 0, static_cast<int>(payload.size()));
  return message;
}

class Soak {
 public:
  Soak(const sim::SimulatorParameters& world, const PipelineConfig& config,
       const SoakParameters& parameters, const std::function<void(const SoakReport&)>& report)
      : laser_(world.laser),
        mounting_(parameters.mounting),
        simulator_(world),
        pipeline_(config, 0, [this](const std::string& channel, Pipeline::Bytes payload) {
          take(channel, payload);
        }) {
    const std::int64_t start = simulator_.utime();
    double next = parameters.period;
    while (next <= parameters.duration) {
      for (const sim::Measurement& measurement : simulator_.advance())
        std::visit([this](const auto& measured) { publish(measured); }, measurement);
      if (seconds_between(start, simulator_.utime()) < next) continue;
      report(take_report(next));
      next += parameters.period;
    }
  }

 private:
  void publish(const sim::OdometryReading& reading) {
    pico::odometry_t message = to_message(reading);
    set_stamp(message, {reading.utime, 1, odometries_++});
    pipeline_.feed(channel::odometry, messages::encode(message));
  }

  void publish(const sim::Sweep& sweep) {
    pico::laser_scan_t scan = to_message(sweep, laser_, mounting_);
    set_stamp(scan, {sweep.utime, 1, scans_++});
    truths_[sweep.utime] = sweep.truth.robot_in_world;
    const auto started = std::chrono::steady_clock::now();
    pipeline_.feed(channel::laser, messages::encode(scan));
    const std::chrono::duration<double, std::micro> spent =
        std::chrono::steady_clock::now() - started;
    spent_us_.push_back(spent.count());
    ++now_.scans;
  }

  void take(const std::string& channel, Pipeline::Bytes payload) {
    if (channel == channel::identified_map) ++now_.maps;
    if (channel == channel::local_map) take_map(decoded<pico::map_t>(payload));
    if (channel == channel::world_position) take_position(decoded<pico::world_position_t>(payload));
    if (channel.starts_with(channel::status_prefix)) {
      const auto status = decoded<pico::status_t>(payload);
      now_.resident = static_cast<double>(status.rss_bytes) / 1e6;
      now_.rejected += losses_of(status).rejected;
    }
  }

  void take_map(const pico::map_t& map) {
    now_.walls = 0;
    for (const pico::map_object_t& object : map.objects)
      if (object.type == pico::map_object_t::WALL) ++now_.walls;
  }

  void take_position(const pico::world_position_t& position) {
    truths_.erase(truths_.begin(), truths_.lower_bound(position.utime));
    if (position.state != pico::world_position_t::TRACKING || truths_.empty()) return;
    ++now_.tracked;
    errors_.push_back(
        distance(to_model(position.robot_in_world).location(), truths_.begin()->second.location()));
  }

  SoakReport take_report(double time) {
    pipeline_.publish_status(simulator_.utime());
    now_.time = time;
    now_.median_us = quantile(spent_us_, 0.5);
    now_.p99_us = quantile(spent_us_, 0.99);
    now_.position_error = quantile(errors_, 0.5);
    spent_us_.clear();
    errors_.clear();
    return std::exchange(now_, {});
  }

  sim::LaserParameters laser_;
  LaserMounting mounting_;
  std::int64_t odometries_ = 0;
  std::int64_t scans_ = 0;
  std::map<std::int64_t, Position> truths_;  ///< of scans whose WORLD_POSITION may still come
  std::vector<double> spent_us_;
  std::vector<double> errors_;
  SoakReport now_;
  sim::Simulator simulator_;
  Pipeline pipeline_;
};

}  // namespace

void soak(const sim::SimulatorParameters& world, const PipelineConfig& config,
          const SoakParameters& parameters, const std::function<void(const SoakReport&)>& report) {
  Soak(world, config, parameters, report);
}

}  // namespace perceptor
