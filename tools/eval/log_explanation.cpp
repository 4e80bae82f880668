#include "tools/eval/log_explanation.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include <pico/laser_scan_t.hpp>
#include <pico/map_t.hpp>
#include <pico/position_t.hpp>

#include "common/bus/bus.hpp"
#include "common/bus/channels.hpp"
#include "common/messages/convert.hpp"

namespace perceptor {
namespace {

/// Ten seconds of scans: a scan and its maps stand closer, and a scan without maps goes.
constexpr std::size_t kKept = 400;

}  // namespace

LogExplainer::LogExplainer(const LogExplanationParameters& parameters, Sink sink)
    : parameters_(parameters),
      sink_(std::move(sink)),
      positions_(AlignerParameters{.max_gap = parameters.max_bracket}) {}

LogExplainer::Trio& LogExplainer::trio_of(const Stamp& stamp) {
  const auto is_of_scan = [&](const Trio& trio) {
    return trio.stamp.session == stamp.session && trio.stamp.seq == stamp.seq;
  };
  // The newest is the likeliest.
  const auto found = std::find_if(waiting_.rbegin(), waiting_.rend(), is_of_scan);
  if (found != waiting_.rend()) return *found;
  if (waiting_.size() == kKept) waiting_.pop_front();
  waiting_.push_back({stamp, {}, {}, {}});
  return waiting_.back();
}

template <class Message, class Add>
void LogExplainer::take_part(const LogEvent& event, std::int64_t& count, Add&& add) {
  Message message;
  if (!detail::decode(event.data, message).empty()) {
    ++result_.undecodable;
    return;
  }
  ++count;
  Trio& trio = trio_of(stamp_of(message));
  add(trio, message);
  if (!trio.scan || !trio.current || !trio.local) return;
  compare(trio);
  std::erase_if(waiting_, [&](const Trio& other) { return other.stamp == trio.stamp; });
}

void LogExplainer::take_position(const LogEvent& event) {
  pico::position_t position;
  if (!detail::decode(event.data, position).empty()) {
    ++result_.undecodable;
    return;
  }
  const Continuity continuity = position_watch_.check(stamp_of(position));
  if (!order_fault(continuity).empty()) return;
  positions_.add(stamp_of(position), continuity == Continuity::began_anew, position.zero_utime,
                 to_model(position.robot_in_zero));
}

void LogExplainer::take(const LogEvent& event) {
  if (event.channel == channel::laser)
    take_part<pico::laser_scan_t>(event, result_.scans, [](Trio& trio, const auto& message) {
      trio.stamp = stamp_of(message);
      trio.scan = to_model(message);
    });
  else if (event.channel == channel::current_map)
    take_part<pico::map_t>(event, result_.current_maps, [](Trio& trio, const auto& message) {
      trio.current = to_model(message);
    });
  else if (event.channel == channel::local_map)
    take_part<pico::map_t>(event, result_.local_maps,
                           [](Trio& trio, const auto& message) { trio.local = to_model(message); });
  else if (event.channel == channel::position)
    take_position(event);
}

void LogExplainer::compare(const Trio& trio) {
  const bool began_anew = map_watch_.check(trio.stamp) == Continuity::began_anew;
  const PositionHistory::Fate fate = positions_.decide(trio.stamp, began_anew);
  const auto* aligned = std::get_if<AlignedPosition>(&fate);
  const std::vector<BeamEnd> ends = beam_ends(*trio.scan, aligned ? aligned->twist : Twist{});
  const std::vector<Vector2> robot = robot_outline(*trio.local);

  MapExplanation map;
  map.stamp = trio.stamp;
  map.is_moved = aligned != nullptr;
  map.by_current = explained_beams(ends, *trio.current, robot, parameters_.explained);
  map.by_local = explained_beams(ends, *trio.local, robot, parameters_.explained);
  map.doubles = count_double_walls(*trio.local, trio.stamp.utime, parameters_.doubles);

  ++result_.compared;
  result_.moved += map.is_moved ? 1 : 0;
  result_.by_current += map.by_current;
  result_.by_local += map.by_local;
  result_.doubles += static_cast<std::int64_t>(map.doubles);
  result_.most_doubles = std::max(result_.most_doubles, map.doubles);
  result_.maps_with_doubles += map.doubles > 0 ? 1 : 0;
  if (sink_) sink_(map);
}

}  // namespace perceptor
