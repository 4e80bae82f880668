/// @file pico-top: channels and components as one table in the terminal, for those on ssh.
/// Channels: all.
#include <algorithm>
#include <chrono>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

#include <unistd.h>

#include "common/bus/bus.hpp"
#include "common/bus/channels.hpp"
#include "common/bus/receiving_socket.hpp"
#include "common/runner/stop_signal.hpp"
#include "tools/cli.hpp"
#include "tools/top/channel_table.hpp"
#include "tools/top/screen.hpp"
#include "tools/top/status_table.hpp"

namespace perceptor {
namespace {

constexpr std::int64_t kPeriod = kMicrosecondsPerSecond / 2;
constexpr std::int64_t kOnce = 3 * kMicrosecondsPerSecond;  // two STATUS of each, and their rates
constexpr int kQueue = 1000;
constexpr int kWait_ms = 100;

struct TopOptions {
  std::string lcm_url;
  bool once = false;
};

std::int64_t monotonic_now() {
  return std::chrono::duration_cast<std::chrono::microseconds>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

/// Listens to everything on the bus.
class Listener {
 public:
  explicit Listener(lcm::LCM& lcm) : status_("top", 0), bus_(lcm, lcm, status_) {
    lcm.subscribe(".*", &Listener::on_message, this)->setQueueCapacity(kQueue);
    bus_.subscribe_command<pico::status_t>(
        std::string(channel::status_prefix) + ".*", kQueue,
        [this](const pico::status_t& status) { components_.take(status, monotonic_now()); });
  }

  std::vector<Row> rows() const {
    std::vector<Row> rows = components_.rows(monotonic_now());
    rows.emplace_back();
    std::ranges::move(channels_.rows(monotonic_now()), std::back_inserter(rows));
    return rows;
  }

 private:
  void on_message(const lcm::ReceiveBuffer* buffer, const std::string& channel) {
    channels_.take(channel, {static_cast<const std::uint8_t*>(buffer->data), buffer->data_size},
                   monotonic_now());
  }

  Status status_;
  Bus bus_;
  ChannelTable channels_;
  StatusTable components_;
};

int print_once(lcm::LCM& lcm, const Listener& listener) {
  const std::int64_t end = monotonic_now() + kOnce;
  while (monotonic_now() < end && !stop_requested()) lcm.handleTimeout(kWait_ms);
  for (const Row& row : listener.rows()) std::cout << row.text << '\n';
  return kExitOk;
}

int keep_showing(lcm::LCM& lcm, const Listener& listener) {
  const Screen screen;
  std::int64_t next = 0;
  while (!stop_requested() && !Screen::wants_to_end()) {
    lcm.handleTimeout(kWait_ms);
    if (monotonic_now() < next) continue;
    Screen::show(listener.rows());
    next = monotonic_now() + kPeriod;
  }
  return kExitOk;
}

int top(const TopOptions& options) {
  catch_stop_signals();
  lcm::LCM lcm(options.lcm_url);
  if (!lcm.good()) {
    print_no_bus("pico-top", options.lcm_url);
    return kExitFailed;
  }
  const Listener listener(lcm);
  ReceivingSockets::guard(options.lcm_url);
  if (options.once || isatty(STDOUT_FILENO) == 0) return print_once(lcm, listener);
  return keep_showing(lcm, listener);
}

}  // namespace
}  // namespace perceptor

int main(int argc, char** argv) {
  perceptor::TopOptions options;
  CLI::App app{
      "Shows the components and all channels of the bus as a table: rates, sizes, latency, and "
      "what "
      "was lost.",
      "pico-top"};
  app.add_option("--lcm-url", options.lcm_url,
                 "the bus; without it LCM_DEFAULT_URL, else LCM's own default");
  app.add_flag("--once", options.once,
               "print the table once, after three seconds; so it does where there is no terminal");
  app.footer("Ends with q or Ctrl-C. pico-watch prints a line a second instead.");
  return perceptor::run_tool(app, argc, argv, [&] { return perceptor::top(options); });
}
