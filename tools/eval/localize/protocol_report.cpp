#include "tools/eval/localize/protocol_report.hpp"

#include <cmath>
#include <limits>

#include <nlohmann/json.hpp>

#include "common/text/format.hpp"
#include "tools/eval/quantile.hpp"

namespace perceptor {
namespace {

using Json = nlohmann::ordered_json;

bool is_false(const JudgedTrial& trial) {
  return trial.outcome.longest_false > OutcomeParameters{}.false_after;
}

bool is_within(const std::optional<double>& time, double seconds) {
  return time && *time <= seconds;
}

auto found_within(double seconds) {
  return [=](const JudgedTrial& trial) { return is_within(trial.outcome.found, seconds); };
}

auto is_shut_flush(double clutter) {
  return [=](const JudgedTrial& trial) {
    return !trial.outcome.is_ambiguous && trial.conditions.clutter == clutter &&
           trial.conditions.doors == Doors::flush;
  };
}

/// What would have told this place from another was seen before kSoon.
auto is_clear_soon(double clutter) {
  return [=](const JudgedTrial& trial) {
    return is_shut_flush(clutter)(trial) && !trial.outcome.is_ambiguous_at_first;
  };
}

bool is_kidnapped(const JudgedTrial& trial) {
  return trial.outcome.was_tracking && !trial.outcome.is_ambiguous_after;
}

Proportion count(const ProtocolLine& line, const std::vector<JudgedTrial>& trials) {
  Proportion proportion;
  for (const JudgedTrial& trial : trials)
    if (line.is_case(trial)) proportion.add(line.is_hit(trial));
  return proportion;
}

/// Found times of clear trials with open doors and no clutter [s]; never found: infinite.
std::vector<double> easy_times(const std::vector<JudgedTrial>& trials) {
  std::vector<double> times;
  for (const JudgedTrial& trial : trials)
    if (!trial.outcome.is_ambiguous && trial.conditions.clutter == 0.0 &&
        trial.conditions.doors == Doors::open)
      times.push_back(trial.outcome.found.value_or(std::numeric_limits<double>::infinity()));
  return times;
}

struct Error {
  const char* name;
  bool (*is_case)(const Conditions&);
};

constexpr double kMostSlip = 0.1;
constexpr Error kErrors[] = {
    {"slip 10 %, not displaced",
     [](const Conditions& c) { return c.displaced == 0.0 && c.slip == kMostSlip; }},
    {"exact map, no clutter",
     [](const Conditions& c) { return c.displaced == 0.0 && c.clutter == 0.0; }},
    {"exact map, no clutter, sigma 0.01",
     [](const Conditions& c) { return c.displaced == 0.0 && c.clutter == 0.0 && c.sigma == 0.01; }},
    {"displaced", [](const Conditions& c) { return c.displaced > 0.0; }}};

struct Rms {
  double distance = 0.0;  ///< [m]
  double degrees = 0.0;
  double nees = 0.0;  ///< mean; 3 is honest
  int fixes = 0;
};

Rms rms(const Error& error, const std::vector<JudgedTrial>& trials) {
  TrackingError sum;
  for (const JudgedTrial& trial : trials)
    if (error.is_case(trial.conditions)) sum += trial.outcome.error;
  const auto mean = [&](double total) { return total / std::max(1, sum.fixes); };
  constexpr double kDegrees = 180.0 / 3.14159265358979323846;
  return {std::sqrt(mean(sum.squared_distance)), kDegrees * std::sqrt(mean(sum.squared_angle)),
          mean(sum.nees), sum.fixes};
}

CombinedScore combined(const std::vector<JudgedTrial>& trials) {
  CombinedScore sum;
  for (const JudgedTrial& trial : trials) sum += trial.outcome.combined;
  return sum;
}

const char* name_of(Doors doors) {
  switch (doors) {
    case Doors::open:
      return "open";
    case Doors::flush:
      return "flush";
    case Doors::recessed:
      return "recessed";
  }
  return "";
}

std::string described(const JudgedTrial& trial) {
  const Conditions& c = trial.conditions;
  return format(
      "  %4zu  %-16s clutter %2.0f %%, %d people, doors %s, slip %.1f %%, sigma %.2f, outliers "
      "%.1f %%, displaced %.2f",
      trial.number, trial.site.c_str(), 100.0 * c.clutter, c.people, name_of(c.doors),
      100.0 * c.slip, c.sigma, 100.0 * c.outliers, c.displaced);
}

Json json_of(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

Json json_of(const JudgedTrial& trial) {
  const Conditions& c = trial.conditions;
  const Outcome& o = trial.outcome;
  Json json = {{"number", trial.number},
               {"site", trial.site},
               {"clutter", c.clutter},
               {"people", c.people},
               {"doors", name_of(c.doors)},
               {"slip", c.slip},
               {"sigma", c.sigma},
               {"outliers", c.outliers},
               {"displaced", c.displaced},
               {"ambiguous", o.is_ambiguous},
               {"ambiguous_at_first", o.is_ambiguous_at_first},
               {"said_ambiguous", o.said_ambiguous},
               {"found", json_of(o.found)},
               {"longest_false", o.longest_false}};
  if (o.was_tracking) {
    json["ambiguous_after"] = o.is_ambiguous_after;
    json["noticed"] = json_of(o.noticed);
    json["found_again"] = json_of(o.found_again);
  }
  return json;
}

}  // namespace

const std::vector<ProtocolLine>& protocol_lines() {
  static const auto always = [](const JudgedTrial&) { return true; };
  static const std::vector<ProtocolLine> lines = {
      {"clutter 20 %, doors shut flush: found in 10 s", 0.97, true, is_shut_flush(0.2),
       found_within(kSoon)},
      {"clutter 20 %, flush, clear by then: in 10 s", 0.97, true, is_clear_soon(0.2),
       found_within(kSoon)},
      {"clutter 20 %, doors shut flush: found in 30 s", 0.99, true, is_shut_flush(0.2),
       found_within(30.0)},
      {"clutter 40 %, doors shut flush: found in 10 s", 0.90, true, is_shut_flush(0.4),
       found_within(kSoon)},
      {"clutter 40 %, flush, clear by then: in 10 s", 0.90, true, is_clear_soon(0.4),
       found_within(kSoon)},
      {"clutter 40 %, doors shut flush: found in 30 s", 0.95, true, is_shut_flush(0.4),
       found_within(30.0)},
      {"all clear starts: found in 30 s", 0.95, true,
       [](const JudgedTrial& trial) { return !trial.outcome.is_ambiguous; }, found_within(30.0)},
      {"clutter up to 20 %: tracking elsewhere", 0.002, false,
       [](const JudgedTrial& trial) { return trial.conditions.clutter < 0.3; }, is_false},
      {"clutter 40 %: tracking elsewhere", 0.01, false,
       [](const JudgedTrial& trial) { return trial.conditions.clutter > 0.3; }, is_false},
      {"ambiguous starts: tracking elsewhere", 0.01, false,
       [](const JudgedTrial& trial) { return trial.outcome.is_ambiguous; }, is_false},
      {"ambiguous starts, of all", 1.0, false, always,
       [](const JudgedTrial& trial) { return trial.outcome.is_ambiguous; }},
      {"kidnapped: noticed in 2 s", 0.95, true, is_kidnapped,
       [](const JudgedTrial& trial) { return is_within(trial.outcome.noticed, 2.0); }},
      {"kidnapped: found again in 10 s", 0.95, true, is_kidnapped,
       [](const JudgedTrial& trial) { return is_within(trial.outcome.found_again, 10.0); }}};
  return lines;
}

std::string report(const std::vector<JudgedTrial>& trials) {
  std::string text = format("%-48s %6s %7s  %s\n", "", "trials", "%", "95 % interval, asked");
  for (const ProtocolLine& line : protocol_lines()) {
    const Proportion proportion = count(line, trials);
    const ConfidenceInterval interval = clopper_pearson(proportion);
    text += format("%-48s %6d %7.2f  %.2f to %.2f, %s %.1f\n", line.name.c_str(), proportion.cases,
                   100.0 * proportion.share(), 100.0 * interval.low, 100.0 * interval.high,
                   line.at_least ? ">=" : "<=", 100.0 * line.asked);
  }
  const std::vector<double> times = easy_times(trials);
  text += format(
      "no clutter, doors open: found after                %4zu  median %.2f s, 95 %% "
      "within %.2f s (asked: 1, 5)\n",
      times.size(), quantile(times, 0.5), quantile(times, 0.95));
  for (const Error& error : kErrors) {
    const Rms e = rms(error, trials);
    text += format("tracking, %-36s  rms %.1f mm, %.3f deg, NEES %.2f (3)\n", error.name,
                   1000.0 * e.distance, e.degrees, e.nees);
  }
  const CombinedScore found = combined(trials);
  text += format("doors in view within 3 m for 1 s: state right    %6d %7.2f  >= 97\n",
                 found.doors.cases, 100.0 * found.doors.share());
  text += format("things in view within 3 m for 3 s: there         %6d %7.2f  >= 95\n",
                 found.objects.cases, 100.0 * found.objects.share());
  text += format("static things that are not: %d in %.2f h tracked (asked: 1 an hour)\n",
                 found.false_objects, found.time / 3600.0);
  std::string failures;
  for (const JudgedTrial& trial : trials) {
    const Outcome& o = trial.outcome;
    std::string what;
    if (o.combined.false_objects > 0)
      what += format(", %d things that are not", o.combined.false_objects);
    if (o.combined.doors.share() < 0.9)
      what += format(", doors %d of %d", o.combined.doors.hits, o.combined.doors.cases);
    if (o.combined.objects.share() < 0.8)
      what += format(", things %d of %d", o.combined.objects.hits, o.combined.objects.cases);
    if (is_false(trial)) what += format(", elsewhere for %.1f s", o.longest_false);
    if (!o.is_ambiguous && !is_within(o.found, 30.0)) what += ", not found";
    if (is_kidnapped(trial) && !is_within(o.noticed, 2.0)) what += ", kidnapping not noticed";
    if (is_kidnapped(trial) && !is_within(o.found_again, 10.0)) what += ", not found again";
    if (o.is_ambiguous && !what.empty()) what += " (ambiguous)";
    if (!what.empty()) failures += described(trial) + ": " + what.substr(2) + "\n";
  }
  if (!failures.empty()) text += "failed (--only NUMBER repeats one):\n" + failures;
  return text;
}

std::string report_json(const std::vector<JudgedTrial>& trials, std::uint64_t seed) {
  Json json = {{"seed", seed}, {"lines", Json::array()}, {"tracking", Json::array()}};
  for (const ProtocolLine& line : protocol_lines()) {
    const Proportion proportion = count(line, trials);
    const ConfidenceInterval interval = clopper_pearson(proportion);
    json["lines"].push_back({{"name", line.name},
                             {"trials", proportion.cases},
                             {"hits", proportion.hits},
                             {"low", interval.low},
                             {"high", interval.high},
                             {line.at_least ? "at_least" : "at_most", line.asked}});
  }
  const std::vector<double> times = easy_times(trials);
  json["easy"] = {
      {"trials", times.size()}, {"median", quantile(times, 0.5)}, {"p95", quantile(times, 0.95)}};
  for (const Error& error : kErrors) {
    const Rms e = rms(error, trials);
    json["tracking"].push_back({{"name", error.name},
                                {"fixes", e.fixes},
                                {"rms_m", e.distance},
                                {"rms_deg", e.degrees},
                                {"nees", e.nees}});
  }
  const CombinedScore found = combined(trials);
  json["combined"] = {{"doors", found.doors.cases},           {"doors_right", found.doors.hits},
                      {"objects", found.objects.cases},       {"objects_found", found.objects.hits},
                      {"false_objects", found.false_objects}, {"hours", found.time / 3600.0}};
  for (const JudgedTrial& trial : trials) json["trials"].push_back(json_of(trial));
  return json.dump(1) + "\n";
}

}  // namespace perceptor
