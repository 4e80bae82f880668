#include "components/bridge/sim_source.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include "common/bus/channels.hpp"
#include "components/bridge/driver_commands.hpp"
#include "components/bridge/sim_messages.hpp"
#include "components/bridge/world_file.hpp"

namespace perceptor {
namespace {

/// Simulated in one step at most [us], so that messages and signals are not kept waiting.
constexpr std::int64_t kLongestStep = 50'000;

sim::SimulatorParameters parameters_of(const BridgeConfig& config) {
  sim::SimulatorParameters parameters =
      read_world(find_world(config.world, config.config_dir), config.robot);
  parameters.drive = config.drive;
  if (config.seed != 0) parameters.seed = config.seed;
  return parameters;
}

}  // namespace

SimSource::SimSource(const BridgeConfig& config, std::int64_t session, Bus& bus)
    : bus_(bus),
      session_(session),
      duration_(static_cast<std::int64_t>(std::llround(config.duration * 1e6))),
      mounting_(config.robot.laser),
      simulator_(parameters_of(config)),
      pace_(config.speed, simulator_.utime()),
      next_world_(simulator_.utime()) {
  subscribe(bus, session,
            {[this](const Twist& wished, std::optional<std::int64_t> measured_at) {
               simulator_.command(wished, measured_at);
             },
             [this](std::optional<int> door) { open_door(door); },
             [this](const std::string& text) { speak(text); }});
}

std::int64_t SimSource::simulated() const {
  return simulator_.utime() - simulator_.parameters().start_utime;
}

bool SimSource::finished() const { return duration_ > 0 && simulated() >= duration_; }

std::int64_t SimSource::step(std::int64_t now) {
  const std::int64_t due = pace_.source_time(now, simulator_.next_due());
  const std::int64_t goal = std::min(due, simulator_.utime() + kLongestStep);
  if (simulator_.utime() >= next_world_) publish_world();
  while (simulator_.utime() + simulator_.parameters().tick <= goal && !finished()) {
    for (const sim::Measurement& measurement : simulator_.advance())
      std::visit([this](const auto& measured) { publish(measured); }, measurement);
    if (simulator_.utime() >= next_world_) publish_world();
  }
  return pace_.clock_time(simulator_.next_due(), now);
}

void SimSource::publish(const sim::OdometryReading& reading) {
  pico::odometry_t message = to_message(reading);
  set_stamp(message, {reading.utime, session_, odometries_++});
  bus_.publish(channel::odometry, message);
}

void SimSource::publish(const sim::Sweep& sweep) {
  const Stamp stamp{sweep.utime, session_, scans_++};
  pico::laser_scan_t scan = to_message(sweep, simulator_.parameters().laser, mounting_);
  set_stamp(scan, stamp);
  bus_.publish(channel::laser, scan);
  pico::truth_t truth = to_message(sweep.truth);
  set_stamp(truth, stamp);
  bus_.publish(channel::truth, truth);
}

void SimSource::publish_world() {
  for (pico::map_t& part : to_messages(simulator_.parameters().world, simulator_.truth().doors)) {
    set_stamp(part, {simulator_.utime(), session_, worlds_++});
    part.map_id = next_world_;
    bus_.publish(channel::world, part);
  }
  next_world_ += kMicrosecondsPerSecond;
  say_how_it_goes();
}

void SimSource::say_how_it_goes() {
  const auto seconds = [](std::int64_t microseconds) {
    return std::to_string(microseconds / kMicrosecondsPerSecond) + " s";
  };
  std::string note = "simulated " + seconds(simulated()) + ", way-points reached " +
                     std::to_string(simulator_.waypoints_reached());
  if (simulator_.truth().in_collision) note += ", stands against something";
  if (pace_.lost() > 0) {
    const std::int64_t milliseconds = pace_.lost() / 1000;
    note += ", cannot keep up: " + std::to_string(milliseconds) + " ms behind";
  }
  if (!spoken_.empty()) note += ", said: " + spoken_;
  bus_.status().set_note(note);
}

void SimSource::open_door(std::optional<int> door) {
  if (!simulator_.request_door(door))
    bus_.reject(channel::open_door, "no such door that opens on request");
}

void SimSource::speak(const std::string& text) {
  spoken_ = text;
  say_how_it_goes();
}

}  // namespace perceptor
