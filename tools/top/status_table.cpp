#include "tools/top/status_table.hpp"

#include <algorithm>
#include <cstdint>

#include "common/bus/losses.hpp"
#include "common/text/format.hpp"
#include "common/time/stamp.hpp"

namespace perceptor {
namespace {

constexpr double kSilent = 3.0;  // [s] without a STATUS, of which there is one a second

std::int64_t published(const pico::status_t& status) {
  std::int64_t sum = 0;
  for (const auto& output : status.outputs) sum += output.published;
  return sum;
}

const char* state_of(const pico::status_t& status) {
  const auto has = [&](std::int8_t state) {
    return std::ranges::any_of(status.inputs,
                               [&](const auto& input) { return input.state == state; });
  };
  if (status.last != 0) return "ended";
  if (status.degraded != 0) return "degraded";
  if (has(pico::status_input_t::STALE)) return "stale";
  const bool has_nothing_to_do = has(pico::status_input_t::WAITING) && published(status) == 0;
  return has_nothing_to_do ? "waiting" : "ok";
}

}  // namespace

void StatusTable::take(const pico::status_t& status, std::int64_t now) {
  Component& component = components_[status.component];
  const bool is_same_process =
      component.now.boot == status.boot && component.now.utime < status.utime;
  component.before = is_same_process ? std::optional(component.now) : std::nullopt;
  component.now = status;
  component.heard = now;
}

std::vector<Row> StatusTable::rows(std::int64_t monotonic_now) const {
  std::vector<Row> rows = {
      {format("%-11s %-9s %7s %8s %8s %8s %8s %6s %7s  %s", "COMPONENT", "state", "Hz", "p50 ms",
              "p99 ms", "rejected", "missed", "CPU %", "MB", "says"),
       Row::Look::title}};
  for (const auto& [name, component] : components_) {
    const pico::status_t& now = component.now;
    double rate = 0.0;
    double load = 0.0;
    if (component.before) {
      const double seconds = seconds_between(component.before->utime, now.utime);
      rate = static_cast<double>(published(now) - published(*component.before)) / seconds;
      load = 100.0 * (now.cpu_s - component.before->cpu_s) / seconds;
    }
    const auto [rejected, missed] = losses_of(now);
    const bool is_silent = seconds_between(component.heard, monotonic_now) > kSilent;
    const bool is_alarming =
        is_silent || rejected > 0 || missed > 0 || now.degraded != 0 || now.last != 0;
    rows.push_back(
        {format("%-11s %-9s %7.1f %8.2f %8.2f %8lld %8lld %6.1f %7.1f  ", name.c_str(),
                is_silent ? "silent" : state_of(now), rate, now.p50_us / 1000.0,
                now.p99_us / 1000.0, static_cast<long long>(rejected),
                static_cast<long long>(missed), load, static_cast<double>(now.rss_bytes) / 1e6) +
             now.note,
         is_alarming ? Row::Look::alarm : Row::Look::plain});
  }
  return rows;
}

}  // namespace perceptor
