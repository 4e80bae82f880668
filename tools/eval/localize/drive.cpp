#include "tools/eval/localize/drive.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <variant>

#include <pico/world_position_t.hpp>

#include "common/bus/channels.hpp"
#include "common/geometry/angle.hpp"
#include "common/log/event_log.hpp"
#include "common/messages/convert.hpp"
#include "common/messages/encode.hpp"
#include "common/time/stamp.hpp"
#include "components/bridge/sim_messages.hpp"

namespace perceptor {
namespace {

constexpr int kBeams = 72;             // of a true view
constexpr double kViewDistance = 0.3;  // [m] between true views
constexpr double kViewAngle = 0.4;     // [rad] the same
constexpr double kRightPlace = 0.3;    // [m] from the truth

std::int64_t microseconds(double seconds) {
  return static_cast<std::int64_t>(std::llround(seconds * 1e6));
}

class Driver {
 public:
  Driver(const PipelineConfig& config, const LaserMounting& mounting,
         const std::filesystem::path& log)
      : mounting_(mounting),
        pipeline_(config, 0, [this](const std::string& channel, Pipeline::Bytes payload) {
          take(channel, payload);
        }) {
    if (!log.empty()) log_ = std::make_unique<LogWriter>(log);
  }

  /// Goes on where the last one ended: odometry does not notice.
  CombinedScore run(sim::SimulatorParameters parameters, Doors doors, double duration,
                    std::vector<Fix>& fixes, std::vector<TrueView>& views) {
    CombinedScorer scorer(parameters.world, doors, {});
    scorer_ = &scorer;
    if (odometry_) {
      parameters.odometry.start_in_odometry = *odometry_;
      parameters.start_utime = utime_;
    }
    sim::Simulator simulator(parameters);
    began_ = simulator.utime();
    fixes_ = &fixes;
    views_ = &views;
    const std::int64_t end = simulator.utime() + microseconds(duration);
    while (simulator.utime() < end)
      for (const sim::Measurement& measurement : simulator.advance())
        std::visit([&](const auto& measured) { publish(measured, parameters.laser); }, measurement);
    utime_ = simulator.utime();
    scorer_ = nullptr;
    return scorer.score();
  }

  void finish() {
    pipeline_.finish(utime_);
    if (log_) log_->close();
  }

 private:
  void publish(const sim::OdometryReading& reading, const sim::LaserParameters&) {
    odometry_ = reading.robot_in_odometry;
    pico::odometry_t message = to_message(reading);
    set_stamp(message, {reading.utime, 1, odometries_++});
    feed(channel::odometry, message);
  }

  void publish(const sim::Sweep& sweep, const sim::LaserParameters& laser) {
    pico::laser_scan_t scan = to_message(sweep, laser, mounting_);
    const Stamp stamp{sweep.utime, 1, scans_++};
    set_stamp(scan, stamp);
    pico::truth_t truth = to_message(sweep.truth);
    set_stamp(truth, stamp);
    utime_ = sweep.completed;
    if (log_) write(channel::truth, messages::encode(truth));
    view(scan, sweep.truth);
    truths_[sweep.utime] = sweep.truth;
    feed(channel::laser, scan);
  }

  void view(const pico::laser_scan_t& scan, const sim::Truth& truth) {
    if (!views_->empty()) {
      const Position step = relative(views_->back().robot_in_world, truth.robot_in_world);
      if (step.location().norm() < kViewDistance && std::abs(step.a) < kViewAngle) return;
    }
    views_->push_back({seconds_between(began_, scan.utime), truth.robot_in_world,
                       localize::choose_beams(beam_ends(to_model(scan), truth.twist), kBeams)});
  }

  template <class Message>
  void feed(const std::string& channel, const Message& message) {
    utime_ = std::max(utime_, message.utime);
    pipeline_.feed(channel, messages::encode(message));
  }

  void write(const std::string& channel, Pipeline::Bytes payload) {
    log_->write(channel, utime_, payload.data(), payload.size());
  }

  void take(const std::string& channel, Pipeline::Bytes payload) {
    if (log_) write(channel, payload);
    if (channel == channel::world_position) take_position(payload);
    if (channel == channel::combined_map) take_combined(payload);
  }

  void take_position(Pipeline::Bytes payload) {
    pico::world_position_t position;
    position.decode(payload.data(), 0, static_cast<int>(payload.size()));
    truths_.erase(truths_.begin(), truths_.lower_bound(position.utime));
    if (truths_.empty() || position.utime < began_) return;
    Fix fix;
    fix.time = seconds_between(began_, position.utime);
    fix.truth = truths_.begin()->second.robot_in_world;
    fix.robot_in_world.pose = to_model(position.robot_in_world);
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column)
        fix.robot_in_world.covariance(row, column) = position.covariance[3 * row + column];
    fix.is_tracking = position.state == pico::world_position_t::TRACKING;
    fix.is_ambiguous = position.ambiguous != 0;
    fixes_->push_back(fix);
  }

  /// Comes after the position of the same scan; of a claim that is wrong nothing is asked.
  void take_combined(Pipeline::Bytes payload) {
    if (scorer_ == nullptr) return;
    pico::map_t message;
    message.decode(payload.data(), 0, static_cast<int>(payload.size()));
    if (message.part == 0) combined_ = {};
    append(combined_, to_model(message));
    if (message.part + 1 < message.parts || truths_.empty() || fixes_->empty()) return;
    const Fix& fix = fixes_->back();
    const double off = distance(fix.truth.location(), fix.robot_in_world.pose.location());
    if (fix.is_tracking && off < kRightPlace)
      scorer_->take(combined_, truths_.begin()->second, fix.time);
  }

  static void append(Map& map, const Map& part) {
    const auto points = static_cast<Index>(map.points.size());
    map.points.insert(map.points.end(), part.points.begin(), part.points.end());
    for (Object object : part.objects) {
      for (Index& point : object.points) point += points;
      map.objects.push_back(std::move(object));
    }
  }

  LaserMounting mounting_;
  std::unique_ptr<LogWriter> log_;
  std::int64_t utime_ = 0;
  std::int64_t began_ = 0;
  std::int64_t odometries_ = 0;
  std::int64_t scans_ = 0;
  std::optional<Position> odometry_;
  std::map<std::int64_t, sim::Truth> truths_;  ///< of scans that wait for their WORLD_POSITION
  std::vector<Fix>* fixes_ = nullptr;
  std::vector<TrueView>* views_ = nullptr;
  CombinedScorer* scorer_ = nullptr;
  Map combined_;  ///< of the parts so far
  Pipeline pipeline_;
};

}  // namespace

Drive drive(const Trial& trial, const Site& site, const ProtocolParameters& parameters,
            PipelineConfig config, const LaserMounting& mounting,
            const std::filesystem::path& log) {
  config.localize->map = site.file.string();
  Drive result;
  Driver driver(config, mounting, log);
  const Doors doors = trial.conditions.doors;
  result.combined =
      driver.run(trial.simulator, doors, parameters.duration, result.fixes, result.views);
  if (trial.kidnapped_to)
    driver.run(*trial.kidnapped_to, doors, parameters.after_kidnapping, result.after,
               result.views_after);
  driver.finish();
  return result;
}

}  // namespace perceptor
