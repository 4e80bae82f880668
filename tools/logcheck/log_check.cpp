#include "tools/logcheck/log_check.hpp"

#include <algorithm>
#include <span>
#include <string_view>

#include <pico/status_t.hpp>

#include "common/bus/channels.hpp"
#include "common/messages/plausible.hpp"
#include "common/messages/schema.hpp"
#include "common/messages/validate.hpp"

namespace perceptor {
namespace {

constexpr std::size_t kShownStepBacks = 10;

bool is_data_of_ours(std::string_view channel) {
  const ChannelKind kind = kind_of(channel);
  return kind == ChannelKind::source || kind == ChannelKind::computed;
}

}  // namespace

void LogCheck::add(const LogEvent& event) {
  watch_stamps(event);
  ChannelRecord& channel = channels_[event.channel];
  channel.count_message(event);
  const lcm_type_info_t* type = channel::type_on(event.channel);
  if (type == nullptr) return;
  std::string_view fault = messages::find_fault(type, event.data);
  Stamp stamp;
  if (fault.empty()) {
    stamp = messages::stamp_in(event.data).value_or(Stamp{});
    fault = messages::fault_of_stamp(stamp);
  }
  if (!fault.empty()) {
    ++channel.undecodable[std::string(fault)];
  } else if (kind_of(event.channel) == ChannelKind::status) {
    add_status(channel, event);
  } else {
    channel.add(stamp.session, stamp.seq);
  }
}

void LogCheck::watch_stamps(const LogEvent& event) {
  const bool is_first = events_ == 0;
  if (!is_first && event.timestamp < previous_stamp_ - kLargeStepBack) {
    ++step_backs_;
    if (first_step_backs_.size() < kShownStepBacks)
      first_step_backs_.push_back({events_, previous_stamp_, event.timestamp});
  }
  earliest_stamp_ = is_first ? event.timestamp : std::min(earliest_stamp_, event.timestamp);
  latest_stamp_ = is_first ? event.timestamp : std::max(latest_stamp_, event.timestamp);
  previous_stamp_ = event.timestamp;
  ++events_;
}

void LogCheck::add_status(ChannelRecord& channel, const LogEvent& event) {
  pico::status_t status;
  const auto size = static_cast<int>(event.data.size());
  const bool is_decoded = status.decode(event.data.data(), 0, size) == size;
  const std::string_view fault = is_decoded ? messages::validate(status) : "decoded size differs";
  if (!fault.empty()) {
    ++channel.undecodable[std::string(fault)];
    return;
  }
  SessionRecord& start = channel.add(status.boot, status.seq);
  start.stopped = start.stopped || status.last;

  const Boot boot{status.component, status.boot};
  const auto [known, is_first_status] = boots_.try_emplace(boot);
  if (is_first_status)
    for (const auto& [name, record] : channels_)
      if (is_data_of_ours(name)) known->second[name] = record.sent();
  for (const pico::status_output_t& output : status.outputs) {
    // Announced, and nothing sent: another may be the publisher.
    if (output.published == 0 || !is_data_of_ours(output.channel)) continue;
    ChannelRecord& out = channels_[output.channel];
    Claim claim;
    claim.component = status.component;
    claim.boot = status.boot;
    claim.published_first = claim.published_last = output.published;
    claim.in_log_first = claim.in_log_last = out.sent();
    claim.session = output.session;
    claim.last_seq = output.last_seq;
    claim.stamp = event.timestamp;
    claim.stopped = status.last;
    out.publishers.add(claim, is_first_status, known->second[output.channel]);
  }
}

LogReport LogCheck::report() const {
  LogReport report;
  report.events = events_;
  report.duration = seconds_between(earliest_stamp_, latest_stamp_);
  report.step_backs = step_backs_;
  report.first_step_backs = first_step_backs_;
  for (const auto& [name, record] : channels_) report.channels.push_back(report_of(name, record));
  return report;
}

LogReport check_log(const std::filesystem::path& file,
                    const std::function<void(std::int64_t, std::int64_t)>& progress) {
  LogReader reader(file);
  LogCheck check;
  for (LogEvent event; reader.next(event);) {
    check.add(event);
    if (progress) progress(reader.offset(), reader.size());
  }
  LogReport report = check.report();
  report.size = reader.size();
  report.damage = reader.damage();
  return report;
}

}  // namespace perceptor
