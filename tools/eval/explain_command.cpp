#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <vector>

#include "common/bus/channels.hpp"
#include "common/runner/runner.hpp"
#include "tools/eval/command.hpp"
#include "tools/eval/log_explanation.hpp"
#include "tools/eval/read_events.hpp"

namespace perceptor {
namespace {

struct ExplainOptions {
  std::vector<std::filesystem::path> logs;
  bool each = false;
};

double percent(std::int64_t part, std::int64_t whole) { return 100.0 * value({part, whole}); }

void print_map(const MapExplanation& map) {
  std::printf("%.6f %lld %lld %.4f %.4f %zu\n", seconds_between(0, map.stamp.utime),
              static_cast<long long>(map.stamp.seq), static_cast<long long>(map.by_local.whole),
              value(map.by_current), value(map.by_local), map.doubles);
}

/// Throws LogError where the log holds nothing to compare.
LogExplanation explain_log(const std::filesystem::path& log, const LogExplainer::Sink& sink) {
  LogExplainer explainer({}, sink);
  read_events(log, [&](const LogEvent& event) { explainer.take(event); });
  const LogExplanation& result = explainer.result();
  const auto require = [&](std::int64_t messages, const char* channel) {
    if (messages == 0) throw LogError(log.string() + " holds no good " + channel + " message");
  };
  require(result.scans, channel::laser);
  require(result.current_maps, channel::current_map);
  require(result.local_maps, channel::local_map);
  if (result.compared == 0)
    throw LogError(log.string() + " holds no scan with both its CURRENT_MAP and its LOCAL_MAP");
  if (result.undecodable > 0)
    std::fprintf(stderr, "pico-eval: %s: %lld messages cannot be decoded\n", log.c_str(),
                 static_cast<long long>(result.undecodable));
  return result;
}

void print_head(std::FILE* out, int name_width) {
  std::fprintf(out, "%-*s  %7s %7s %7s  %8s %8s %6s  %8s %5s %7s\n", name_width, "log", "scans",
               "maps", "moved", "CURRENT", "LOCAL", "ratio", "doubles", "most", "maps");
  std::fprintf(out, "%-*s  %7s %7s %7s  %8s %8s %6s  %8s %5s %7s\n", name_width, "", "", "", "%",
               "%", "%", "%", "a map", "", "% any");
}

void print_row(std::FILE* out, int name_width, const std::string& name, const LogExplanation& log) {
  const double current = value(log.by_current);
  const double local = value(log.by_local);
  std::fprintf(out, "%-*s  %7lld %7lld %7.1f  %8.2f %8.2f %6.1f  %8.3f %5zu %7.2f\n", name_width,
               name.c_str(), static_cast<long long>(log.scans),
               static_cast<long long>(log.compared), percent(log.moved, log.compared),
               100.0 * current, 100.0 * local, current > 0.0 ? 100.0 * local / current : 0.0,
               value({log.doubles, log.compared}), log.most_doubles,
               percent(log.maps_with_doubles, log.compared));
}

int run_explain(const ExplainOptions& options) {
  std::FILE* table = options.each ? stderr : stdout;
  std::size_t name_width = 3;
  for (const auto& log : options.logs)
    name_width = std::max(name_width, log.filename().string().size());
  const auto width = static_cast<int>(name_width);
  print_head(table, width);
  const LogExplainer::Sink sink = options.each ? print_map : LogExplainer::Sink{};
  for (const auto& log : options.logs)
    print_row(table, width, log.filename().string(), explain_log(log, sink));
  return kExitOk;
}

}  // namespace

Command add_explain_command(CLI::App& app) {
  CLI::App* explain = app.add_subcommand(
      "explain", "how much of the scans the local map explains, and its double walls");
  const auto options = std::make_shared<ExplainOptions>();
  explain
      ->add_option("LOG", options->logs,
                   "LCM event logs with PICO_LASER, CURRENT_MAP and LOCAL_MAP")
      ->required();
  explain->add_flag("--each", options->each,
                    "print a line for each map (t seq beams CURRENT LOCAL doubles, shares from 0\n"
                    "to 1), and the table on standard error");
  explain->footer(
      "Columns:\n"
      "  scans    PICO_LASER messages\n"
      "  maps     of those, with both their CURRENT_MAP and their LOCAL_MAP\n"
      "  moved    of those, with the robot's motion known from POSITION: the beams end where the\n"
      "           laser was when it measured them, else as if the robot had stood still\n"
      "  CURRENT  valid beams under 5 m that end within 5 cm of a wall of the scan itself\n"
      "  LOCAL    the same, of a wall of the local map; ratio: LOCAL of CURRENT\n"
      "  doubles  pairs of walls of one local map seen within 30 s, parallel within 10 degrees,\n"
      "           free on the same side, overlapping by more than 0.3 m, less than 0.3 m apart:\n"
      "           mean and most in a map, and the share of maps with any\n"
      "Examples:\n"
      "  pico-eval explain out.lcmlog\n"
      "  pico-eval explain out.lcmlog --each | sort -nk 5 | head    # the worst explained scans");
  return {explain, [options] { return run_explain(*options); }};
}

}  // namespace perceptor
