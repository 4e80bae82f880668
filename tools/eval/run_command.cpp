#include <cstdio>
#include <filesystem>
#include <memory>
#include <numbers>

#include "common/runner/runner.hpp"
#include "tools/eval/command.hpp"
#include "tools/eval/read_events.hpp"
#include "tools/eval/run_summary.hpp"

namespace perceptor {
namespace {

double percent(std::int64_t part, std::int64_t whole) {
  return whole > 0 ? 100.0 * static_cast<double>(part) / static_cast<double>(whole) : 0.0;
}

double degrees(double radians) { return radians * 180.0 / std::numbers::pi; }

void print_messages(const RunSummary& summary) {
  std::printf("messages\n");
  for (const auto& [channel, count] : summary.messages())
    std::printf("  %-18s %8lld\n", channel.c_str(), static_cast<long long>(count));
  if (summary.undecodable() > 0)
    std::printf("  %lld of them cannot be decoded\n",
                static_cast<long long>(summary.undecodable()));
}

void print_latency(const Latency& latency) {
  if (latency.maps == 0) return;
  std::printf("latency from PICO_LASER to IDENTIFIED_MAP, %zu maps [ms]\n", latency.maps);
  std::printf("  %-24s median %7.2f   p99 %7.2f\n", "in all", latency.total.median,
              latency.total.p99);
  std::printf("  %-24s median %7.2f   p99 %7.2f\n", "waiting for odometry", latency.waiting.median,
              latency.waiting.p99);
  std::printf("  %-24s median %7.2f   p99 %7.2f\n", "computing and hops", latency.computing.median,
              latency.computing.p99);
}

void print_score(const WorldScore& score) {
  std::printf("against the truth, %lld maps, %.1f m driven\n", static_cast<long long>(score.maps),
              score.driven);
  std::printf("  walls that lie on a wall of the world   %5.1f %% of %lld\n",
              percent(score.walls_right, score.walls), static_cast<long long>(score.walls));
  std::printf("  doors that lie in an opening            %5.1f %% of %lld\n",
              percent(score.doors_right, score.doors), static_cast<long long>(score.doors));
  std::printf("  openings of the world found             %zu of %zu\n", score.openings_found,
              score.openings);
  std::printf("  drift at the end: odometry %.3f m %.2f deg, merge %.3f m %.2f deg\n",
              score.odometry_at_end.distance, degrees(score.odometry_at_end.angle),
              score.merge_at_end.distance, degrees(score.merge_at_end.angle));
}

int print_summary(const std::filesystem::path& log) {
  RunSummary summary;
  read_events(log, [&](const LogEvent& event) { summary.take(event); });
  print_messages(summary);
  print_latency(summary.latency());
  if (const auto score = summary.score()) print_score(*score);
  return kExitOk;
}

}  // namespace

Command add_run_command(CLI::App& app) {
  CLI::App* run = app.add_subcommand(
      "run", "messages by channel, latency, and what was found against the simulator's truth");
  const auto log = std::make_shared<std::filesystem::path>();
  run->add_option("LOG", *log, "an LCM event log")->required();
  return {run, [log] { return print_summary(*log); }};
}

}  // namespace perceptor
