#include "tools/convert/event_writer.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include <pico/laser_scan_t.hpp>
#include <pico/odometry_t.hpp>

#include "common/bus/bus.hpp"
#include "common/bus/channels.hpp"
#include "common/messages/convert.hpp"
#include "common/messages/validate.hpp"
#include "common/time/stamp.hpp"

namespace perceptor {
namespace {

/// [us] Between the outermost scans of a standing robot and the odometry around them.
constexpr std::int64_t kStillMargin = 20'000;

/// [m] Lasers say "no return" with ranges of up to some centimetres.
constexpr double kDerivedValidMin = 0.05;

/// Of range_max: lasers say "no return" with range_max and a little noise, and never measure
/// a return that far.
constexpr double kDerivedValidShare = 0.99;

std::string metres(double value) {
  std::ostringstream text;
  text << value << " m";
  return text.str();
}

}  // namespace

EventWriter::EventWriter(std::filesystem::path file, const EventWriterOptions& options)
    : file_(std::move(file)), options_(options) {}

void EventWriter::begin(std::int64_t utime) {
  if (status_) return;
  // Session 0 stands for "unknown" in commands.
  session_ = options_.session.value_or(std::max<std::int64_t>(utime, 1));
  status_.emplace("convert", session_);
}

template <class Message>
std::string_view EventWriter::write(const char* channel, Message& message) {
  if (const auto fault = messages::validate(message); !fault.empty()) return fault;
  if (!log_) {
    log_.emplace(file_);
    first_utime_ = message.utime;
    last_utime_ = message.utime;
  }
  first_utime_ = std::min(first_utime_, message.utime);
  last_utime_ = std::max(last_utime_, message.utime);
  const auto bytes = messages::encode(message);
  log_->write(channel, last_utime_, bytes.data(), bytes.size());
  status_->published(channel, stamp_of(message));
  return {};
}

std::string_view EventWriter::add(const OdometryRecord& odometry) {
  if (options_.still) return drop_reason::replaced;
  begin(odometry.utime);
  pico::odometry_t message{};
  set_stamp(message, {odometry.utime, session_, odometry_});
  message.robot_in_odometry = to_message(odometry.robot_in_odometry);
  const std::string_view fault = write(channel::odometry, message);
  if (fault.empty()) ++odometry_;
  return fault;
}

void EventWriter::write_standing(std::int64_t utime) {
  if (utime < 0 || utime == last_standing_) return;
  pico::odometry_t message{};
  set_stamp(message, {utime, session_, odometry_});
  write(channel::odometry, message);
  ++odometry_;
  last_standing_ = utime;
}

std::string_view EventWriter::add(const ScanRecord& scan) {
  begin(scan.utime);
  const bool is_min_recorded = scan.valid_min > 0.0;
  const bool is_max_recorded = scan.valid_max > 0.0;
  const bool is_range_max_recorded = std::isfinite(scan.range_max) && scan.range_max > 0.0;
  if (!options_.valid_max && !is_max_recorded && !is_range_max_recorded)
    return drop_reason::no_valid_range;
  const double valid_min = is_min_recorded ? scan.valid_min : kDerivedValidMin;
  const double valid_max = is_max_recorded ? scan.valid_max : kDerivedValidShare * scan.range_max;

  pico::laser_scan_t message{};
  set_stamp(message, {scan.utime, session_, scans_});
  message.laser_in_robot = to_message(scan.laser_in_robot);
  message.time_increment = options_.time_increment.value_or(scan.time_increment);
  message.valid_min = options_.valid_min.value_or(valid_min);
  message.valid_max = options_.valid_max.value_or(valid_max);
  message.range_sigma = options_.range_sigma;
  message.ranges = scan.ranges;
  message.num_ranges = static_cast<std::int32_t>(scan.ranges.size());
  message.bearings = scan.bearings;
  message.num_bearings = static_cast<std::int32_t>(scan.bearings.size());
  if (scan.bearings.empty()) {
    message.angle_min = scan.angle_min;
    message.angle_increment = scan.angle_increment;
    message.angle_max = scan.angle_min + (message.num_ranges - 1) * scan.angle_increment;
  }
  if (const auto fault = messages::validate(message); !fault.empty()) return fault;

  if (options_.still) {
    if (scans_ == 0) write_standing(scan.utime - kStillMargin);
    write_standing(scan.utime);
  }
  write(channel::laser, message);
  ++scans_;
  if (!options_.valid_min && !is_min_recorded) derived_valid_min_ = valid_min;
  if (!options_.valid_max && !is_max_recorded) derived_valid_max_ = valid_max;
  return {};
}

void EventWriter::count_dropped(std::string_view reason) { ++dropped_[reason]; }

void EventWriter::finish() {
  if (!log_) return;
  if (options_.still) write_standing(last_utime_ + kStillMargin);
  for (const auto& [reason, count] : dropped_) status_->counted("input", reason, count);
  pico::status_t message = status_->message(last_utime_, true);
  // What this very run used is not part of the recording.
  message.rss_bytes = 0;
  message.cpu_s = 0.0;
  const auto bytes = messages::encode(message);
  log_->write(status_->channel(), last_utime_, bytes.data(), bytes.size());
  log_->close();
}

std::vector<std::string> EventWriter::notes() const {
  std::vector<std::string> notes;
  if (derived_valid_min_)
    notes.push_back("no valid_min recorded: shorter than " + metres(*derived_valid_min_) +
                    " is no return (--valid-min says otherwise)");
  if (derived_valid_max_)
    notes.push_back("no valid_max recorded: longer than " + metres(*derived_valid_max_) +
                    ", 1 % below the laser's maximum, is no return (--valid-max says otherwise)");
  if (scans_ > 0 && odometry_ == 0)
    notes.emplace_back(
        "no odometry: the components drop every scan. If the robot stood still, --still gives "
        "it one");
  return notes;
}

}  // namespace perceptor
