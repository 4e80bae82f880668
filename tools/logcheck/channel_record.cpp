#include "tools/logcheck/channel_record.hpp"

#include <algorithm>
#include <functional>
#include <optional>

#include "common/bus/channels.hpp"
#include "common/time/stamp.hpp"

namespace perceptor {
namespace {

/// Sums of hostile sequence numbers stop here instead of overflowing.
constexpr std::int64_t kMostMissing = std::int64_t{1} << 61U;

/// A datagram that the network delivers twice comes again within so many messages of its channel.
constexpr std::size_t kRecent = 64;

std::int64_t total(const std::vector<SeqRange>& ranges) {
  std::int64_t sum = 0;
  for (const SeqRange& range : ranges) sum = std::min(sum + range.size(), kMostMissing);
  return sum;
}

/// What the last STATUS that names a session says was its last seq.
std::optional<std::int64_t> last_seq_claimed(const ChannelRecord& record, std::int64_t session) {
  std::optional<std::int64_t> last_seq;
  for (const Claim& claim : record.publishers.claims())
    if (claim.session == session && claim.last_seq >= 0) last_seq = claim.last_seq;
  return last_seq;
}

std::string describe(const SessionReport& session, std::string_view what) {
  constexpr std::size_t shown = 10;
  std::string text = std::to_string(total(session.missing)) + " missing from " + std::string(what) +
                     " " + std::to_string(session.session) + ": seq";
  for (std::size_t i = 0; i < std::min(session.missing.size(), shown); ++i) {
    const SeqRange& range = session.missing[i];
    text += (i == 0 ? " " : ", ") + std::to_string(range.first);
    if (range.last > range.first) text += ".." + std::to_string(range.last);
  }
  if (session.missing.size() > shown)
    text += " and " + std::to_string(session.missing.size() - shown) + " more gaps";
  return text;
}

/// The log may have begun in the middle of its first session.
bool may_begin_late(const ChannelRecord& record, const SessionRecord& session) {
  if (&session != &record.sessions.front()) return false;
  const auto& claims = record.publishers.claims();
  return claims.empty() || claims.front().published_first > claims.front().in_log_first;
}

/// Channels whose seq has no gaps: what is missing by seq is added to the report.
void check_sequence(const ChannelRecord& record, bool is_status, ChannelReport& report) {
  for (std::size_t i = 0; i < record.sessions.size(); ++i) {
    const SessionRecord& session = record.sessions[i];
    SessionReport& out = report.sessions[i];
    if (session.seqs.empty()) continue;
    out.repeated = session.repeated;
    out.missing = session.seqs.gaps();
    const SeqRange head{0, session.seqs.first() - 1};
    const bool is_late = is_status ? i == 0 : may_begin_late(record, session);
    if (head.last >= head.first) {
      if (is_late)
        report.reasons.push_back("the log began at seq " + std::to_string(head.last + 1));
      else
        out.missing.insert(out.missing.begin(), head);
    }
    const auto last_seq = last_seq_claimed(record, session.session);
    if (!is_status && last_seq && *last_seq > session.seqs.last())
      out.missing.push_back({session.seqs.last() + 1, *last_seq});
    if (!out.missing.empty()) {
      report.missing = std::min(report.missing + total(out.missing), kMostMissing);
      report.reasons.push_back(describe(out, is_status ? "boot" : "session"));
    }
  }
}

void check_status(const ChannelRecord& record, ChannelReport& report) {
  check_sequence(record, true, report);
  for (const SessionRecord& session : record.sessions)
    if (!session.stopped)
      report.reasons.push_back("no last STATUS of boot " + std::to_string(session.session) +
                               ": killed, or the log ended before it");
}

void check_data(const ChannelRecord& record, bool is_source, ChannelReport& report) {
  if (is_source) check_sequence(record, false, report);
  const std::int64_t missing_by_seq = report.missing;
  ClaimedCompleteness claimed = record.publishers.check(record.sent());
  report.losses = std::move(claimed.losses);
  // Both ways of counting see the same loss.
  if (claimed.missing > missing_by_seq) {
    report.missing = claimed.missing;
    for (std::string& reason : claimed.missing_reasons) report.reasons.push_back(std::move(reason));
  } else if (missing_by_seq > 0 && claimed.missing == 0 && claimed.unproven.empty()) {
    report.reasons.emplace_back("lost before the publisher: it says that it sent what is here");
  }
  for (std::string& reason : claimed.unproven) report.reasons.push_back(std::move(reason));
}

}  // namespace

void ChannelRecord::count_message(const LogEvent& event) {
  if (count == 0) first_stamp = event.timestamp;
  last_stamp = event.timestamp;
  ++count;
  const std::size_t hash = std::hash<std::string_view>()(
      {reinterpret_cast<const char*>(event.data.data()), event.data.size()});
  if (std::ranges::find(recent, hash) != recent.end()) ++delivered_twice;
  recent.push_back(hash);
  if (recent.size() > kRecent) recent.pop_front();
}

SessionRecord& ChannelRecord::add(std::int64_t session, std::int64_t seq) {
  const auto [known, is_new] = session_index.try_emplace(session, sessions.size());
  if (is_new) sessions.emplace_back().session = session;
  SessionRecord& record = sessions[known->second];
  ++record.count;
  if (!record.seqs.add(seq)) ++record.repeated;
  return record;
}

ChannelKind kind_of(std::string_view name) {
  if (name == "LCM_SELF_TEST" || name == "LOG_PROBE") return ChannelKind::internal;
  if (channel::type_on(name) == nullptr) return ChannelKind::foreign;
  if (name.starts_with(channel::status_prefix)) return ChannelKind::status;
  const bool is_source = name.starts_with("PICO_") || name.starts_with("SIM_");
  return is_source ? ChannelKind::source : ChannelKind::computed;
}

ChannelReport report_of(const std::string& channel, const ChannelRecord& record) {
  ChannelReport report;
  report.channel = channel;
  report.count = record.count;
  report.undecodable = record.undecodable;
  const double span = seconds_between(record.first_stamp, record.last_stamp);
  if (record.count > 1 && span > 0.0) report.rate = static_cast<double>(record.count - 1) / span;
  for (const SessionRecord& session : record.sessions) {
    SessionReport& out = report.sessions.emplace_back();
    out.session = session.session;
    out.count = session.count;
    out.first_seq = session.seqs.first();
    out.last_seq = session.seqs.last();
  }

  const ChannelKind kind = kind_of(channel);
  if (kind == ChannelKind::internal) {
    report.verdict = Verdict::not_checked;
    return report;
  }
  if (kind == ChannelKind::foreign)
    report.reasons.emplace_back("no channel of ours: nothing to count by");
  else if (kind == ChannelKind::status)
    check_status(record, report);
  else
    check_data(record, kind == ChannelKind::source, report);
  for (const auto& [fault, count] : record.undecodable)
    report.reasons.push_back(std::to_string(count) + " cannot be decoded: " + fault);

  if (!report.undecodable.empty())
    report.verdict = Verdict::damaged;
  else if (report.missing > 0)
    report.verdict = Verdict::missing;
  else if (!report.reasons.empty())
    report.verdict = Verdict::not_provable;
  return report;
}

}  // namespace perceptor
