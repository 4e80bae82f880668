#include "common/runner/runner.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <iostream>

#include "common/bus/receiving_socket.hpp"
#include "common/runner/heartbeat.hpp"
#include "common/runner/memory.hpp"
#include "common/runner/stop_signal.hpp"

namespace perceptor {
namespace {

constexpr std::int64_t kStatusPeriod = kMicrosecondsPerSecond;
constexpr int kDrainQuiet_ms = 150;  // nothing for this long: the input is drained
constexpr std::int64_t kDrainLimit = 5 * kMicrosecondsPerSecond;

template <class Clock>
std::int64_t microseconds() {
  return std::chrono::duration_cast<std::chrono::microseconds>(Clock::now().time_since_epoch())
      .count();
}
std::int64_t monotonic_now() { return microseconds<std::chrono::steady_clock>(); }
std::int64_t wall_now() { return microseconds<std::chrono::system_clock>(); }

/// Counts what the kernel kept out of the bus's socket.
class BusGuard {
 public:
  explicit BusGuard(const std::string& lcm_url) : sockets_(ReceivingSockets::guard(lcm_url)) {}

  void count_drops(Status& status) {
    const std::int64_t drops = sockets_.drops();
    status.lost("bus", "no whole message, or no room for it", drops - counted_);
    counted_ = drops;
  }

 private:
  ReceivingSockets sockets_;
  std::int64_t counted_ = 0;
};

/// Waits for one message, at most so long, and handles it. False: the bus is broken.
bool handle_one(lcm::LCM& lcm, int timeout_ms) {
  return lcm.handleTimeout(timeout_ms) >= 0 || errno == EINTR;
}

void drain(lcm::LCM& lcm, Bus& bus, Heartbeat& heartbeat) {
  const std::int64_t give_up = monotonic_now() + kDrainLimit;
  while (monotonic_now() < give_up &&
         (lcm.handleTimeout(bus.has_waiting() ? 0 : kDrainQuiet_ms) > 0 || bus.has_waiting())) {
    bus.check_what_came();
    bus.handle_next();
    heartbeat.beat(monotonic_now());
  }
}

void print_news(const Face& face, Status& status) {
  for (const std::string& line : status.take_news())
    std::cerr << "pico-" << face.name << ": " << line << std::endl;
}

ExitCode spin(const Face& face, lcm::LCM& lcm, Bus& bus, BusGuard& guard, const Work& work) {
  const auto publish_status = [&](bool last) {
    guard.count_drops(bus.status());
    bus.publish_status(wall_now(), last);
  };
  publish_status(false);
  Heartbeat heartbeat;
  heartbeat.ready();
  std::int64_t next_status = monotonic_now() + kStatusPeriod;
  while (!stop_requested() && !work.finished()) {
    const std::int64_t next_step = work.step(monotonic_now());
    const std::int64_t next_beat = heartbeat.beat(monotonic_now());
    const std::int64_t wait = std::min({next_step, next_status, next_beat}) - monotonic_now();
    const std::int64_t wait_ms =
        bus.has_waiting() ? 0 : std::max<std::int64_t>(0, (wait + 999) / 1000);
    if (!handle_one(lcm, static_cast<int>(wait_ms))) {
      std::cerr << "pico-" << face.name << ": the bus broke while waiting for messages\n";
      return kExitFailed;
    }
    bus.check_what_came();
    bus.handle_next();
    if (monotonic_now() >= next_status) {
      publish_status(false);
      print_news(face, bus.status());
      next_status = std::max(next_status + kStatusPeriod, monotonic_now());
    }
  }
  work.stop();
  drain(lcm, bus, heartbeat);
  work.finish();
  publish_status(true);
  if (bus.takes_all()) drain(lcm, bus, heartbeat);  // its own last word too
  print_news(face, bus.status());
  return kExitOk;
}

}  // namespace

void print_no_bus(std::string_view program, const std::string& lcm_url) {
  std::cerr << program << ": cannot open the bus "
            << (lcm_url.empty() ? "(LCM's default)" : lcm_url)
            << ". Is there a route for multicast? On one machine, as root:\n"
               "  ip link set lo multicast on; ip route add 224.0.0.0/4 dev lo\n";
}

ExitCode run(const Face& face, const Options& options, const std::function<Work(Bus&)>& start) {
  catch_stop_signals();
  keep_freed_memory();
  lcm::LCM lcm(options.lcm_url);
  if (!lcm.good()) {
    print_no_bus("pico-" + std::string(face.name), options.lcm_url);
    return kExitFailed;
  }
  Status status{std::string(face.name), wall_now()};
  Bus bus(lcm, lcm, status);
  bus.let_messages_wait();
  try {
    const Work work = start(bus);
    BusGuard guard(options.lcm_url);
    return spin(face, lcm, bus, guard, work);
  } catch (const config::Error& error) {
    std::cerr << "pico-" << face.name << ": " << error.what() << '\n';
    return kExitUsage;
  } catch (const std::exception& error) {
    std::cerr << "pico-" << face.name << ": " << error.what() << '\n';
    return kExitFailed;
  }
}

}  // namespace perceptor
