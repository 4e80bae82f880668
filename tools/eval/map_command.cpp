#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "common/runner/runner.hpp"
#include "tools/eval/command.hpp"
#include "tools/eval/map_score.hpp"
#include "tools/eval/quantile.hpp"
#include "tools/eval/read_events.hpp"

namespace perceptor {
namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

struct MapOptions {
  std::vector<std::filesystem::path> logs;
  bool tells_faults = false;
};

struct Column {
  const char* name;
  const char* unit;
  int decimals;
  bool more_is_better;
  double (*of)(const MapScore&);  ///< NaN: nothing to have a value of
};

double percent(const Share& share) { return share.whole > 0 ? 100.0 * value(share) : kNothing; }

double delay(const MapScore& score, double share) {
  return score.doors.delays.empty() ? kNothing : quantile(score.doors.delays, share);
}

constexpr std::array kColumns = {
    Column{"walls", "%", 1, true, [](const MapScore& s) { return percent(s.walls); }},
    Column{"sides", "%", 1, true, [](const MapScore& s) { return percent(s.furniture); }},
    Column{"right", "%", 1, true, [](const MapScore& s) { return percent(s.right); }},
    Column{"doubles", "a map", 3, false,
           [](const MapScore& s) {
             return s.maps > 0 ? value({s.doubles, s.maps}) : kNothing;
           }},
    Column{"corners", "mm rms", 1, false,
           [](const MapScore& s) {
             return s.corners.right.part > 0 ? 1000.0 * s.corners.rms() : kNothing;
           }},
    Column{"at one", "%", 1, true, [](const MapScore& s) { return percent(s.corners.right); }},
    Column{"type", "% wrong", 2, false,
           [](const MapScore& s) { return percent(s.corners.confused); }},
    Column{"doors", "% right", 1, true, [](const MapScore& s) { return percent(s.doors.right); }},
    Column{"found", "%", 1, true, [](const MapScore& s) { return percent(s.doors.found); }},
    Column{"standing", "%", 1, true, [](const MapScore& s) { return percent(s.doors.standing); }},
    Column{"delay", "s median", 2, false, [](const MapScore& s) { return delay(s, 0.5); }},
    Column{"delay", "s most", 2, false, [](const MapScore& s) { return delay(s, 1.0); }},
};

void print_head(int width) {
  std::printf("%-*s  %5s", width, "log", "maps");
  for (const Column& column : kColumns) std::printf(" %8s", column.name);
  std::printf("\n%-*s  %5s", width, "", "");
  for (const Column& column : kColumns) std::printf(" %8s", column.unit);
  std::printf("\n");
}

void print_value(double value, int decimals) {
  if (std::isnan(value))
    std::printf(" %8s", "-");
  else
    std::printf(" %8.*f", decimals, value);
}

/// Over the logs that have a value.
void print_summary(int width, const char* name, const std::vector<MapScore>& scores, bool worst) {
  std::printf("%-*s  %5s", width, name, "");
  for (const Column& column : kColumns) {
    std::vector<double> values;
    for (const MapScore& score : scores)
      if (const double value = column.of(score); !std::isnan(value)) values.push_back(value);
    const double share = !worst ? 0.5 : column.more_is_better ? 0.0 : 1.0;
    print_value(values.empty() ? kNothing : quantile(values, share), column.decimals);
  }
  std::printf("\n");
}

/// Throws LogError where the log holds nothing to score.
MapScore score_log(const std::filesystem::path& log, const MapScorer::Sink& sink) {
  MapScorer scorer({}, sink);
  read_events(log, [&](const LogEvent& event) { scorer.take(event); });
  MapScore score = scorer.score();
  if (score.maps == 0)
    throw LogError(log.string() + " holds no LOCAL_MAP with SIM_TRUTH and SIM_WORLD to score it");
  return score;
}

int score_maps(const MapOptions& options) {
  std::size_t longest = 6;
  for (const auto& log : options.logs) longest = std::max(longest, log.filename().string().size());
  const auto width = static_cast<int>(longest);
  print_head(width);
  std::vector<MapScore> scores;
  for (const auto& log : options.logs) {
    const std::string name = log.filename().string();
    const MapScorer::Sink tell = [&](const std::string& line) {
      std::fprintf(stderr, "%s %s\n", name.c_str(), line.c_str());
    };
    scores.push_back(score_log(log, options.tells_faults ? tell : MapScorer::Sink{}));
    std::printf("%-*s  %5lld", width, name.c_str(), static_cast<long long>(scores.back().maps));
    for (const Column& column : kColumns) print_value(column.of(scores.back()), column.decimals);
    std::printf("\n");
    std::fflush(stdout);
  }
  if (scores.size() > 1) {
    print_summary(width, "median", scores, false);
    print_summary(width, "worst", scores, true);
  }
  return kExitOk;
}

}  // namespace

Command add_map_command(CLI::App& app) {
  const auto options = std::make_shared<MapOptions>();
  CLI::App* map = app.add_subcommand(
      "map", "local and identified maps of simulated logs against the truth, a row for each log");
  map->add_option("LOG", options->logs,
                  "LCM event logs with PICO_LASER, SIM_TRUTH, SIM_WORLD, LOCAL_MAP, IDENTIFIED_MAP")
      ->required();
  map->add_flag("--faults", options->tells_faults,
                "tell on standard error what is wrong with each map that is scored");
  map->footer(
      "A map each half second is scored, from 2 s on, laid into the world by the true pose.\n"
      "Columns:\n"
      "  walls    walls of the world seen so far, of which the map holds 70 % of what was seen,\n"
      "           within 5 degrees and 0.1 m; seen: 10 beams on 0.3 m in one scan, within 8 m\n"
      "  sides    the same of cabinets and boxes\n"
      "  right    walls of the map that lie on a wall of the world or a side\n"
      "  doubles  pairs of walls of the map that stand for one: within 10 degrees and 0.15 m,\n"
      "           overlapping by 0.2 m, seen from the same side\n"
      "  corners  connected corners against true ones within 0.15 m; at one: those that have one;\n"
      "           type: convex taken for concave, or the other way\n"
      "  doors    doors published within 3 m of the robot that are there: the middle within\n"
      "           0.15 m, the width within 0.10 m; neither way within 0.3 m of furniture\n"
      "  found    openings of 0.5 to 1.5 m within 3 m for 1 s, published at least once\n"
      "  standing the same over the maps: published in this one\n"
      "  delay    from the first scan with both jambs and 10 beams on 0.3 m of both walls, to\n"
      "           the first map with the door; those found from farther away have none\n"
      "Twenty random worlds, from nothing to a table:\n"
      "  pico-eval worlds out --worlds 20 --seed 1\n"
      "  for w in out/worlds/*.json; do\n"
      "    pico-bridge --world $w --speed 0 --duration 120 \\\n"
      "      --lcm-url \"file://${w%.json}.sim?mode=w\"\n"
      "    pico-replay ${w%.json}.sim ${w%.json}.lcmlog\n"
      "  done\n"
      "  pico-eval map out/worlds/*.lcmlog");
  return {map, [options] { return score_maps(*options); }};
}

}  // namespace perceptor
