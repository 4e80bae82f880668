#include "components/bridge/log_source.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "common/config/fields.hpp"

namespace perceptor {
namespace {

/// Published in one step at most: messages and signals are not kept waiting.
constexpr int kMostEvents = 20;

/// A longer pause between two messages is none of the robot's.
constexpr double kLargestStep_us = 60e6;

constexpr const char* kPrefix = "PICO_";

LogReader open(const std::filesystem::path& file) {
  try {
    return LogReader(file);
  } catch (const LogError& error) {
    throw config::Error(std::string("/source: ") + error.what());
  }
}

}  // namespace

LogSource::LogSource(const std::filesystem::path& file, double speed, double duration, Bus& bus)
    : bus_(bus),
      reader_(open(file)),
      duration_(static_cast<std::int64_t>(std::llround(duration * 1e6))),
      pace_(speed, 0) {
  read_next();
  if (at_end_) throw config::Error("/source: " + file.string() + " holds no PICO_* message");
  first_ = due_;
  next_note_ = first_;
  pace_ = Pace(speed, first_);
}

void LogSource::read_next() {
  bool found = false;
  try {
    do {
      found = reader_.next(next_);
    } while (found && !next_.channel.starts_with(kPrefix));
  } catch (const LogError&) {
    bus_.count("log", "cannot be read on", 1);
    found = false;
  }
  const std::size_t damaged = reader_.damage().size();
  if (damaged > damage_told_)
    bus_.count("log", "damaged stretch", static_cast<std::int64_t>(damaged - damage_told_));
  damage_told_ = damaged;

  const bool is_first = published_ == 0;
  if (found) advance_due(is_first);
  const bool is_past_duration = duration_ > 0 && !is_first && due_ - first_ >= duration_;
  at_end_ = !found || is_past_duration;
}

/// Stamps step back a little in every log. A large step either way is a damaged stamp or a clock
/// that was set: the log goes on at once from there.
void LogSource::advance_due(bool is_first) {
  const std::int64_t stamp = next_.timestamp;
  const double step_us = static_cast<double>(stamp) - static_cast<double>(last_stamp_);
  const bool is_jump = std::abs(step_us) > kLargestStep_us;
  if (is_first) {
    due_ = 0;
  } else if (is_jump) {
    bus_.count("log", "stamp jumped", 1);
  } else {
    due_ += std::max<std::int64_t>(0, stamp - last_stamp_);
  }
  if (is_first || is_jump || stamp > last_stamp_) last_stamp_ = stamp;
}

std::int64_t LogSource::step(std::int64_t now) {
  if (at_end_) return now;
  const std::int64_t log_time = pace_.source_time(now, due_);
  for (int i = 0; i < kMostEvents && !at_end_ && due_ <= log_time; ++i) {
    bus_.publish_recorded(next_.channel, next_.data);
    ++published_;
    if (due_ >= next_note_) say_how_it_goes();
    read_next();
  }
  if (at_end_) say_how_it_goes();
  return at_end_ ? now : pace_.clock_time(due_, now);
}

void LogSource::say_how_it_goes() {
  next_note_ = due_ + 1'000'000;
  const std::int64_t seconds = (due_ - first_) / 1'000'000;
  const double read = static_cast<double>(reader_.offset()) /
                      static_cast<double>(std::max<std::int64_t>(1, reader_.size()));
  std::string note = "log time " + std::to_string(seconds) + " s, " +
                     std::to_string(std::lround(100.0 * read)) + " % read, " +
                     std::to_string(published_) + " messages";
  if (pace_.lost() > 0)
    note += ", cannot keep up: " + std::to_string(pace_.lost() / 1000) + " ms behind";
  bus_.status().set_note(note);
}

}  // namespace perceptor
