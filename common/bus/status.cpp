#include "common/bus/status.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cinttypes>
#include <cstdio>

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include "common/bus/channels.hpp"

namespace perceptor {
namespace {

constexpr std::size_t kRecent = 1000;  // processing times kept for the quantiles

/// The file stays open: a replay asks for several components, and opening it costs more than
/// the rest of a STATUS.
std::int64_t resident_bytes() {
  static const int statm = open("/proc/self/statm", O_RDONLY | O_CLOEXEC);
  std::array<char, 128> text{};
  const ssize_t length = pread(statm, text.data(), text.size() - 1, 0);
  std::int64_t resident_pages = 0;
  const bool is_read = length > 0 && std::sscanf(text.data(), "%*d %" SCNd64, &resident_pages) == 1;
  return is_read ? resident_pages * sysconf(_SC_PAGESIZE) : 0;
}

double seconds(const timeval& t) {
  return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
}

double processor_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

}  // namespace

Status::Status(std::string component, std::int64_t boot)
    : component_(std::move(component)), boot_(boot) {}

std::string Status::channel() const {
  std::string name(channel::status_prefix);
  for (const char c : component_)
    name += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return name;
}

void Status::add_input(const std::string& channel, bool waits) { inputs_[channel].waits = waits; }

void Status::received(const std::string& channel) { ++inputs_[channel].received; }

void Status::watched(const std::string& channel, const ContinuityWatch& watch) {
  Input& input = inputs_[channel];
  input.missed = watch.missed();
  input.restarts = watch.restarts();
  input.is_contested = watch.is_contested();
}

void Status::accepted(const std::string& channel, const Stamp& stamp) {
  inputs_[channel].last_utime = stamp.utime;
}

void Status::rejected(const std::string& channel, std::string_view reason) {
  ++inputs_[channel].rejected;
  const Reason why{channel, reason};
  ++reasons_[why];
  ++news_[why];
}

void Status::counted(std::string_view channel, std::string_view reason, std::int64_t count) {
  if (count > 0) reasons_[{std::string(channel), std::string(reason)}] += count;
}

void Status::lost(std::string_view channel, std::string_view reason, std::int64_t count) {
  if (count <= 0) return;
  const Reason why{std::string(channel), std::string(reason)};
  reasons_[why] += count;
  news_[why] += count;
}

void Status::published(const std::string& channel, const Stamp& stamp) {
  Output& output = outputs_[channel];
  ++output.published;
  output.last = stamp;
}

void Status::processing_time(double microseconds) {
  const auto slot = static_cast<std::size_t>(processed_) % kRecent;
  if (recent_us_.size() < kRecent)
    recent_us_.push_back(microseconds);
  else
    recent_us_[slot] = microseconds;
  ++processed_;
  max_us_ = std::max(max_us_, microseconds);
}

void Status::degrade(std::string_view why) {
  if (degraded_.empty()) degraded_ = why;
}

void Status::set_note(std::string_view note) { note_ = note; }

std::string Status::note() const {
  std::string waits;
  for (const auto& [channel, input] : inputs_)
    if (input.waits && input.received == 0)
      waits += (waits.empty() ? "waiting for " : ", ") + channel;
  std::string contested;
  for (const auto& [channel, input] : inputs_)
    if (input.is_contested)
      contested += (contested.empty() ? "two sources take turns on " : ", ") + channel;
  std::string text = waits;
  for (const std::string& part : {contested, degraded_, note_})
    if (!part.empty()) text += (text.empty() ? "" : "; ") + part;
  return text;
}

double Status::quantile_us(double share) const {
  if (recent_us_.empty()) return 0.0;
  std::vector<double> sorted = recent_us_;
  const auto rank = static_cast<std::ptrdiff_t>(share * static_cast<double>(sorted.size() - 1));
  std::nth_element(sorted.begin(), sorted.begin() + rank, sorted.end());
  return sorted[static_cast<std::size_t>(rank)];
}

pico::status_t Status::message(std::int64_t utime, bool last) {
  pico::status_t status{};
  status.utime = utime;
  status.boot = boot_;
  status.seq = seq_++;
  status.component = component_;
  status.version = PERCEPTOR_VERSION;
  status.degraded = degraded_.empty() ? 0 : 1;
  status.last = last ? 1 : 0;
  status.note = note();

  for (auto& [channel, input] : inputs_) {
    const bool silent = input.received == input.received_at_last_status;
    input.silent_statuses = silent ? input.silent_statuses + 1 : 0;
    input.received_at_last_status = input.received;

    pico::status_input_t entry{};
    entry.channel = channel;
    entry.state = input.received == 0          ? pico::status_input_t::WAITING
                  : input.silent_statuses >= 2 ? pico::status_input_t::STALE
                                               : pico::status_input_t::OK;
    entry.received = input.received;
    entry.rejected = input.rejected;
    entry.missed = input.missed;
    entry.restarts = input.restarts;
    entry.last_utime = input.last_utime;
    status.inputs.push_back(entry);
  }
  status.num_inputs = static_cast<std::int32_t>(status.inputs.size());

  for (const auto& [reason, count] : reasons_) {
    pico::status_reject_t entry{};
    entry.channel = reason.first;
    entry.reason = reason.second;
    entry.count = count;
    status.rejects.push_back(entry);
  }
  status.num_rejects = static_cast<std::int32_t>(status.rejects.size());

  for (const auto& [channel, output] : outputs_) {
    pico::status_output_t entry{};
    entry.channel = channel;
    entry.published = output.published;
    entry.session = output.last.session;
    entry.last_seq = output.last.seq;
    status.outputs.push_back(entry);
  }
  status.num_outputs = static_cast<std::int32_t>(status.outputs.size());

  status.processed = processed_;
  status.p50_us = quantile_us(0.50);
  status.p99_us = quantile_us(0.99);
  status.max_us = max_us_;
  status.rss_bytes = resident_bytes();
  status.cpu_s = processor_seconds();
  return status;
}

std::vector<std::string> Status::take_news() {
  std::vector<std::string> lines;
  lines.reserve(news_.size());
  for (const auto& [reason, count] : news_)
    lines.push_back(reason.first + ": rejected " + std::to_string(count) + " (" + reason.second +
                    ")");
  news_.clear();
  return lines;
}

}  // namespace perceptor
