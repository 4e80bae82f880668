#include "tools/logcheck/report.hpp"

#include <algorithm>
#include <iomanip>
#include <ostream>

#include <nlohmann/json.hpp>

namespace perceptor {
namespace {

constexpr std::size_t kShownDamage = 10;
constexpr std::size_t kShownReasons = 10;

double seconds(std::int64_t utime) { return static_cast<double>(utime) * 1e-6; }

void print_channels(std::ostream& out, const std::vector<ChannelReport>& channels) {
  std::size_t width = 7;
  for (const ChannelReport& channel : channels) width = std::max(width, channel.channel.size());
  const auto name_width = static_cast<int>(width);
  out << std::left << std::setw(name_width) << "channel" << std::right << std::setw(10) << "count"
      << std::setw(10) << "rate/Hz" << std::setw(10) << "sessions" << std::setw(9) << "missing"
      << "  verdict\n";
  for (const ChannelReport& channel : channels)
    out << std::left << std::setw(name_width) << channel.channel << std::right << std::setw(10)
        << channel.count << std::setw(10) << std::fixed << std::setprecision(1) << channel.rate
        << std::setw(10) << channel.sessions.size() << std::setw(9) << channel.missing << "  "
        << to_string(channel.verdict) << '\n';
}

void print_reasons(std::ostream& out, const ChannelReport& channel) {
  for (std::size_t i = 0; i < std::min(channel.reasons.size(), kShownReasons); ++i)
    out << channel.channel << ": " << channel.reasons[i] << '\n';
  if (channel.reasons.size() > kShownReasons)
    out << channel.channel << ": and " << channel.reasons.size() - kShownReasons << " more\n";
  std::size_t shown = 0;
  for (const Loss& loss : channel.losses)
    if (++shown <= kShownReasons)
      out << channel.channel << ":   " << loss.count << " of them from " << std::fixed
          << std::setprecision(3) << seconds(loss.from) << " s to " << seconds(loss.to) << " s\n";
}

void print_damage(std::ostream& out, const LogReport& report) {
  std::int64_t lost = 0;
  for (const LogDamage& damage : report.damage) lost += damage.size;
  if (report.damage.empty()) return;
  out << "damaged: " << lost << " of " << report.size << " bytes hold no event\n";
  for (std::size_t i = 0; i < std::min(report.damage.size(), kShownDamage); ++i)
    out << "  at byte " << report.damage[i].offset << ": " << report.damage[i].size << " bytes"
        << (report.damage[i].offset + report.damage[i].size == report.size ? ", to the end" : "")
        << '\n';
  if (report.damage.size() > kShownDamage)
    out << "  and " << report.damage.size() - kShownDamage << " more places\n";
  if (report.events == 0) out << "  Is this an LCM event log? Compressed ones: unpack first.\n";
}

void print_step_backs(std::ostream& out, const LogReport& report) {
  if (report.step_backs == 0) return;
  out << "the log's stamps step back by more than 1 s " << report.step_backs << " times\n"
      << std::fixed << std::setprecision(3);
  for (const StepBack& step : report.first_step_backs)
    out << "  at event " << step.event << ": from " << seconds(step.from) << " s to "
        << seconds(step.to) << " s\n";
}

nlohmann::ordered_json to_json(const ChannelReport& channel) {
  nlohmann::ordered_json json = {{"channel", channel.channel},
                                 {"verdict", to_string(channel.verdict)},
                                 {"count", channel.count},
                                 {"missing", channel.missing},
                                 {"rate_hz", channel.rate},
                                 {"undecodable", channel.undecodable},
                                 {"reasons", channel.reasons},
                                 {"sessions", nlohmann::ordered_json::array()},
                                 {"losses", nlohmann::ordered_json::array()}};
  for (const SessionReport& session : channel.sessions) {
    auto ranges = nlohmann::ordered_json::array();
    for (const SeqRange& range : session.missing) ranges.push_back({range.first, range.last});
    json["sessions"].push_back({{"session", session.session},
                                {"count", session.count},
                                {"first_seq", session.first_seq},
                                {"last_seq", session.last_seq},
                                {"repeated", session.repeated},
                                {"missing", std::move(ranges)}});
  }
  for (const Loss& loss : channel.losses)
    json["losses"].push_back(
        {{"count", loss.count}, {"from_utime", loss.from}, {"to_utime", loss.to}});
  return json;
}

}  // namespace

std::string_view to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::complete:
      return "complete";
    case Verdict::not_checked:
      return "not checked";
    case Verdict::not_provable:
      return "not provable";
    case Verdict::missing:
      return "missing";
    case Verdict::damaged:
      return "damaged";
  }
  return "";
}

Verdict LogReport::verdict() const {
  if (!damage.empty()) return Verdict::damaged;
  if (events == 0) return Verdict::not_provable;
  Verdict worst = Verdict::complete;
  for (const ChannelReport& channel : channels)
    if (channel.verdict != Verdict::not_checked) worst = std::max(worst, channel.verdict);
  return worst;
}

int exit_code(const LogReport& report) {
  switch (report.verdict()) {
    case Verdict::complete:
    case Verdict::not_checked:
      return 0;
    case Verdict::not_provable:
      return 3;
    case Verdict::missing:
    case Verdict::damaged:
      break;
  }
  return 1;
}

void print(std::ostream& out, const LogReport& report) {
  out << report.events << " events, " << report.size << " bytes, " << std::fixed
      << std::setprecision(1) << report.duration << " s\n";
  if (!report.channels.empty()) print_channels(out, report.channels);
  for (const ChannelReport& channel : report.channels) print_reasons(out, channel);
  print_step_backs(out, report);
  print_damage(out, report);
  if (report.events == 0 && report.damage.empty()) out << "the log is empty\n";
  out << "verdict: " << to_string(report.verdict()) << '\n';
}

std::string to_json(const LogReport& report) {
  nlohmann::ordered_json json = {{"verdict", to_string(report.verdict())},
                                 {"events", report.events},
                                 {"bytes", report.size},
                                 {"duration_s", report.duration},
                                 {"step_backs", report.step_backs},
                                 {"damage", nlohmann::ordered_json::array()},
                                 {"channels", nlohmann::ordered_json::array()}};
  for (const LogDamage& damage : report.damage)
    json["damage"].push_back({{"offset", damage.offset}, {"bytes", damage.size}});
  for (const ChannelReport& channel : report.channels) json["channels"].push_back(to_json(channel));
  // Channel names come from the file: what is no UTF-8 must not stop the report.
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

}  // namespace perceptor
