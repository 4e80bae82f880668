#include "components/record/record_component.hpp"

#include <system_error>

#include "common/text/format.hpp"
#include "common/time/stamp.hpp"

namespace perceptor {
namespace {

namespace fs = std::filesystem;

constexpr double kMegabyte = 1e6;

/// [MB] for who is not root.
double free_space_beside(const fs::path& file) {
  std::error_code unknown;
  const fs::space_info space = fs::space(fs::absolute(file).parent_path(), unknown);
  return unknown ? 0.0 : static_cast<double>(space.available) / kMegabyte;
}

bool holds_something(const fs::path& file) {
  std::error_code not_there;
  const auto size = fs::file_size(file, not_there);
  return !not_there && size > 0;
}

/// One that goes on after this process died is not refused for a disk that filled meanwhile: the
/// robot is driving.
record::Recording begin(const RecordConfig& config) {
  const fs::path file = config.file;
  const bool is_there = holds_something(file);
  if (is_there && config.existing == RecordConfig::Existing::refuse)
    throw config::Error(config.file +
                        ": is there already; allowed: another --file, or --existing "
                        "append or replace");
  const bool goes_on = is_there && config.existing == RecordConfig::Existing::append;
  const double free_space = free_space_beside(file);
  if (!goes_on && free_space < config.min_free)
    throw config::Error(config.file + ": " + format("%.0f", free_space) +
                        " MB of its disk are free; allowed: at least min_free, " +
                        format("%.0f", config.min_free) + " MB");
  try {
    return {file, goes_on ? LogWriter::Mode::append : LogWriter::Mode::replace};
  } catch (const LogError& error) {
    throw config::Error(error.what());
  }
}

}  // namespace

void describe(config::Fields& fields, RecordConfig& config) {
  using Existing = RecordConfig::Existing;
  fields.text("file", config.file, "an LCM event log, as lcm-logger writes it");
  fields.choice(
      "existing", config.existing,
      {{"refuse", Existing::refuse}, {"append", Existing::append}, {"replace", Existing::replace}},
      "what becomes of a file of that name");
  fields.number("min_free", config.min_free, {0.0, 1e9},
                "[MB] of the disk that have to be free before a recording begins");
  fields.number("flush_period", config.flush_period, {0.01, 60.0},
                "[s] from one writing out to the next: what a sudden death costs at most");
}

RecordComponent::RecordComponent(const RecordConfig& config, Bus& bus)
    : bus_(bus),
      file_(config.file),
      min_free_(config.min_free),
      period_(static_cast<std::int64_t>(kMicrosecondsPerSecond * config.flush_period)),
      recording_(begin(config)) {
  bus.subscribe_all([this](const Bus::Anything& message) -> std::string_view {
    if (!is_channel_name(message.channel)) return "no name for a channel";
    recording_.add(message.channel, message.received_at, message.payload);
    return {};
  });
  tell();
}

std::int64_t RecordComponent::step(std::int64_t now) {
  if (now < next_) return next_;
  recording_.flush();
  tell();
  next_ = now + period_;
  return next_;
}

void RecordComponent::finish() {
  recording_.flush();
  tell();
}

void RecordComponent::tell() {
  const std::int64_t lost = recording_.take_lost();
  bus_.status().lost("record", "could not be written", lost);
  if (lost > 0) bus_.status().degrade("messages are missing in the recording");
  const double free_space = free_space_beside(file_);
  std::string note = file_.filename().string() + ": " +
                     format("%.1f", static_cast<double>(recording_.size()) / kMegabyte) + " MB";
  if (free_space < min_free_) note += ", only " + format("%.0f", free_space) + " MB are free";
  if (!recording_.trouble().empty()) note = "not recording: " + recording_.trouble();
  bus_.status().set_note(note);
}

}  // namespace perceptor
