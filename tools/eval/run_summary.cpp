#include "tools/eval/run_summary.hpp"

#include <algorithm>

#include <pico/laser_scan_t.hpp>
#include <pico/map_t.hpp>
#include <pico/position_t.hpp>
#include <pico/truth_t.hpp>

#include "common/bus/bus.hpp"
#include "common/bus/channels.hpp"
#include "common/time/position_history.hpp"
#include "tools/eval/quantile.hpp"

namespace perceptor {
namespace {

Spread spread(const std::vector<double>& values) {
  return {quantile(values, 0.50), quantile(values, 0.99)};
}

double milliseconds(std::int64_t microseconds) { return 1e-3 * static_cast<double>(microseconds); }

}  // namespace

void RunSummary::take(const LogEvent& event) {
  ++messages_[event.channel];
  const auto decoded = [&]<class Message>(Message& message) {
    if (detail::decode(event.data, message).empty()) return true;
    ++undecodable_;
    return false;
  };
  if (event.channel == channel::laser) {
    if (pico::laser_scan_t scan; decoded(scan))
      scans_[{scan.session, scan.seq}] = {scan.utime, event.timestamp};
  } else if (event.channel == channel::position) {
    if (pico::position_t position; decoded(position))
      positions_[position.session].push_back({position.utime, event.timestamp});
  } else if (event.channel == channel::truth) {
    if (pico::truth_t truth; decoded(truth)) scorer_.take(truth);
  } else if (event.channel == channel::world) {
    if (pico::map_t world; decoded(world)) scorer_.take_world(world);
  } else if (event.channel == channel::identified_map) {
    if (pico::map_t map; decoded(map)) {
      identified_.push_back({{map.session, map.seq}, event.timestamp});
      scorer_.take_identified(map);
    }
  }
}

Latency RunSummary::latency() const {
  std::vector<double> total;
  std::vector<double> waiting;
  std::vector<double> computing;
  for (const auto& [key, map_arrival] : identified_) {
    const auto scan = scans_.find(key);
    const auto session = positions_.find(key.first);
    if (scan == scans_.end() || session == positions_.end()) continue;
    const auto bracket = std::ranges::lower_bound(
        session->second, scan->second.utime - PositionHistory::kSameTime, {}, &Times::utime);
    if (bracket == session->second.end()) continue;

    const std::int64_t scan_arrival = scan->second.arrival;
    const std::int64_t ready = std::max(scan_arrival, bracket->arrival);
    total.push_back(milliseconds(map_arrival - scan_arrival));
    waiting.push_back(milliseconds(ready - scan_arrival));
    computing.push_back(milliseconds(map_arrival - ready));
  }
  return {total.size(), spread(total), spread(waiting), spread(computing)};
}

std::optional<WorldScore> RunSummary::score() const { return scorer_.score(); }

}  // namespace perceptor
