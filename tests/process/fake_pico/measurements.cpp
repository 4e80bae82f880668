#include "tests/process/fake_pico/measurements.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/config/robot.hpp"
#include "components/bridge/world_file.hpp"

namespace perceptor::test {
namespace {

/// [us] From the stamp of the real robot's scan to its arrival.
constexpr std::int64_t kDelay = 34'000;
/// The real robot's scans come after 25 ms, and now and then after 50: each tenth is left out.
constexpr std::int64_t kLeftOut = 10;
/// Its last beams meet its own body.
constexpr std::size_t kOwnBody = 4;
constexpr float kOwnBodyRange = 0.11F;  // [m]
/// [ns] Laser and odometry of a cycle are stamped one after the other.
constexpr std::int64_t kLaserOffset = 460;
constexpr std::int64_t kOdometryOffset = 560;
/// [m] A miss is told as 0 or as range_max, give or take this.
constexpr double kMissNoise = 0.01;

sim::SimulatorParameters parameters_of(const FakeOptions& options) {
  sim::SimulatorParameters parameters = read_world(options.world, Robot{});
  parameters.drive = options.drive;
  parameters.command_lifetime = 1e9;  // [s] a robot that drives on until it hears another
  sim::LaserParameters& laser = parameters.laser;
  laser.missed_value = sim::MissedValue::inf;
  if (options.model == Model::pico) {
    laser.beams = 1081;
    laser.angle_min = -2.35619449;
    laser.angle_max = 2.35619449;
    laser.valid_min = 0.023;
    laser.valid_max = 60.0;
    laser.range_max = 60.0;
    laser.noise_sigma = 0.005;
    laser.missed = 0.01;
    laser.rate = 40.0;
    laser.sweep_time = 0.01875;
  }
  if (options.model == Model::simulator) {
    laser.range_max = 10.0;
    laser.noise = sim::NoiseKind::uniform;
    laser.noise_sigma = 0.01 / std::sqrt(3.0);  // from -0.01 to 0.01
    laser.missed = 0.01;
    laser.rate = 30.0;
    laser.sweep_time = 0.0;
    parameters.odometry.rate = 30.0;
  }
  if (options.rate > 0.0) laser.rate = options.rate;
  return parameters;
}

}  // namespace

Measurements::Measurements(const FakeOptions& options, std::int64_t base)
    : options_(options), base_(base), simulator_(parameters_of(options)) {}

RosFace::Scan Measurements::scan_of(const sim::Sweep& sweep) {
  const sim::LaserParameters& laser = simulator_.parameters().laser;
  RosFace::Scan scan;
  scan.stamp = base_ + sweep.utime * 1000 + kLaserOffset;
  scan.angle_min = laser.angle_min;
  scan.angle_max = laser.angle_max;
  scan.angle_increment = sim::angle_increment(laser);
  scan.time_increment = sim::time_increment(laser);
  scan.range_min = laser.valid_min;
  scan.range_max = laser.range_max;
  scan.ranges = sweep.ranges;
  std::uniform_real_distribution<double> noise(-kMissNoise, kMissNoise);
  for (float& range : scan.ranges) {
    if (std::isfinite(range) || options_.miss == Miss::infinity) continue;
    const double miss = options_.miss == Miss::zero ? 0.0 : laser.range_max;
    range = static_cast<float>(miss + noise(random_));
  }
  if (options_.model == Model::pico) std::fill_n(scan.ranges.rbegin(), kOwnBody, kOwnBodyRange);
  return scan;
}

void Measurements::advance() {
  for (const sim::Measurement& measurement : simulator_.advance()) {
    if (const auto* sweep = std::get_if<sim::Sweep>(&measurement)) {
      const bool is_left_out =
          options_.model == Model::pico && options_.rate == 0.0 && sweeps_ % kLeftOut == 9;
      ++sweeps_;
      if (is_left_out) continue;
      const std::int64_t delay = options_.model == Model::pico ? kDelay : 0;
      due_.push_back({std::max(sweep->completed, sweep->utime + delay), scan_of(*sweep), {}});
    } else {
      const auto& reading = std::get<sim::OdometryReading>(measurement);
      const Position& pose = reading.robot_in_odometry;
      due_.push_back({reading.utime,
                      {},
                      RosFace::Odometry{base_ + reading.utime * 1000 + kOdometryOffset, pose.x,
                                        pose.y, pose.a}});
    }
  }
}

Measurements::Due Measurements::next() {
  const auto earliest = [this] {
    return std::ranges::min_element(due_, {}, [](const Due& due) { return due.at; });
  };
  while (due_.empty() || earliest()->at > simulator_.utime()) advance();
  const auto first = earliest();
  Due next = std::move(*first);
  due_.erase(first);
  return next;
}

}  // namespace perceptor::test
