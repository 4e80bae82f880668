/// @file pico-watch: one line a second for each component, and the state of the map. Also
/// waits for components, or for a recording to have begun, so that scripts can start things in
/// order.
/// Channels: STATUS_*, IDENTIFIED_MAP, WORLD_POSITION, ENTRANCE, PROXIMITY. With --wait-log it
/// sends LOG_PROBE.
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "common/bus/bus.hpp"
#include "common/bus/channels.hpp"
#include "common/bus/receiving_socket.hpp"
#include "common/runner/stop_signal.hpp"
#include "tools/cli.hpp"
#include "tools/watch/board.hpp"

namespace perceptor {
namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

constexpr int kProbePeriod_ms = 10;

struct WatchOptions {
  std::string lcm_url;
  std::vector<std::string> wait_for;
  std::filesystem::path wait_log;
  double timeout = 20.0;
  bool check = false;
};

bool has_grown(const std::filesystem::path& log) {
  std::error_code not_there;
  const auto size = std::filesystem::file_size(log, not_there);
  return !not_there && size > 0;
}

/// lcm-logger does not say when it is ready: only what it wrote shows that it records.
bool wait_for_log(lcm::LCM& lcm, const WatchOptions& options) {
  const auto give_up = Clock::now() + Seconds(options.timeout);
  while (!has_grown(options.wait_log)) {
    if (Clock::now() > give_up || stop_requested()) {
      std::cerr << "pico-watch: nothing was written to " << options.wait_log.string() << " within "
                << options.timeout << " s: is lcm-logger running on this bus?\n";
      return false;
    }
    lcm.publish("LOG_PROBE", "?", 1);
    lcm.handleTimeout(kProbePeriod_ms);
  }
  return true;
}

bool wait_for_components(lcm::LCM& lcm, const Board& board, const WatchOptions& options) {
  const auto give_up = Clock::now() + Seconds(options.timeout);
  const auto silent = [&] {
    std::string names;
    for (const std::string& name : options.wait_for)
      if (!board.has_heard(name)) names += " " + name;
    return names;
  };
  while (!silent().empty()) {
    if (Clock::now() > give_up || stop_requested()) {
      std::cerr << "pico-watch: no STATUS within " << options.timeout << " s from:" << silent()
                << '\n';
      return false;
    }
    lcm.handleTimeout(100);
  }
  return true;
}

void watch(lcm::LCM& lcm, const Board& board) {
  const auto started = Clock::now();
  auto next = started + Seconds(1);
  while (!stop_requested()) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(next - Clock::now());
    if (left.count() > 0) {
      lcm.handleTimeout(static_cast<int>(left.count()) + 1);
      continue;
    }
    std::cout << static_cast<int>(Seconds(next - started).count()) << " s\n";
    for (const std::string& line : board.lines()) std::cout << "  " << line << '\n';
    std::cout << std::flush;
    next += std::chrono::seconds(1);
  }
}

int watch_bus(const WatchOptions& options) {
  catch_stop_signals();
  lcm::LCM lcm(options.lcm_url);
  if (!lcm.good()) {
    print_no_bus("pico-watch", options.lcm_url);
    return kExitFailed;
  }
  if (options.check) return kExitOk;
  if (!options.wait_log.empty()) return wait_for_log(lcm, options) ? kExitOk : kExitFailed;

  Status status("watch", 0);
  Bus bus(lcm, lcm, status);
  Board board;
  bus.subscribe_command<pico::status_t>(std::string(channel::status_prefix) + ".*", 200,
                                        [&](const pico::status_t& s) { board.take(s); });
  ReceivingSockets::guard(options.lcm_url);
  if (!options.wait_for.empty())
    return wait_for_components(lcm, board, options) ? kExitOk : kExitFailed;

  bus.subscribe_command<pico::map_t>(channel::identified_map, 2,
                                     [&](const pico::map_t& m) { board.take(m); });
  bus.subscribe_command<pico::world_position_t>(
      channel::world_position, 2, [&](const pico::world_position_t& p) { board.take(p); });
  bus.subscribe_command<pico::entrance_t>(channel::entrance, 2,
                                          [&](const pico::entrance_t& e) { board.take(e); });
  bus.subscribe_command<pico::proximity_t>(channel::proximity, 2,
                                           [&](const pico::proximity_t& p) { board.take(p); });
  watch(lcm, board);
  return kExitOk;
}

}  // namespace
}  // namespace perceptor

int main(int argc, char** argv) {
  perceptor::WatchOptions options;
  CLI::App app{"Prints one line a second for each component and the state of the map.",
               "pico-watch"};
  app.add_option("--lcm-url", options.lcm_url,
                 "the bus; without it LCM_DEFAULT_URL, else LCM's own default");
  app.add_option("--wait", options.wait_for,
                 "only wait for a STATUS of each of these components (locate,scan,...), and exit")
      ->delimiter(',')
      ->allow_extra_args(false);
  app.add_option("--wait-log", options.wait_log,
                 "only wait until lcm-logger has written to this file, and exit");
  app.add_flag("--check", options.check, "only open the bus; exit code 1 where that fails");
  app.add_option("--timeout", options.timeout, "[s] give up waiting: exit code 1")
      ->capture_default_str();
  app.footer(
      "Stop with Ctrl-C. Examples:\n"
      "  pico-watch\n"
      "  pico-watch --wait locate,scan,merge && pico-bridge");
  return perceptor::run_tool(app, argc, argv, [&] { return perceptor::watch_bus(options); });
}
