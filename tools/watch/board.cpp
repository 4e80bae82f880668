#include "tools/watch/board.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

#include "common/bus/losses.hpp"
#include "common/messages/convert.hpp"
#include "common/text/format.hpp"
#include "common/time/stamp.hpp"

namespace perceptor {
namespace {

std::int64_t published_on(const pico::status_t& status, const std::string& channel) {
  for (const auto& output : status.outputs)
    if (output.channel == channel) return output.published;
  return 0;
}

/// Where a component stands in the data flow; strangers come last.
int rank(const std::string& component) {
  static constexpr std::array<std::string_view, 9> kFlow = {"bridge",    "locate",   "proximity",
                                                            "scan",      "merge",    "identify",
                                                            "globalmap", "localize", "viewer"};
  return static_cast<int>(std::ranges::find(kFlow, component) - kFlow.begin());
}

std::string rates(const pico::status_t& now, const pico::status_t& before, double seconds) {
  std::string text;
  for (const auto& output : now.outputs) {
    const auto since = static_cast<double>(output.published - published_on(before, output.channel));
    text += format("%s %.1f/s  ", output.channel.c_str(), since / seconds);
  }
  return text;
}

std::string component_line(const pico::status_t& now, const std::optional<pico::status_t>& before) {
  std::string line = format("%-10s", now.component.c_str());
  const bool comparable = before && before->boot == now.boot && now.utime > before->utime;
  if (comparable) {
    const double seconds = seconds_between(before->utime, now.utime);
    line += rates(now, *before, seconds);
    line += format("cpu %.1f %%  ", 100.0 * (now.cpu_s - before->cpu_s) / seconds);
  }
  line += format("p50 %.2f ms  p99 %.2f ms  rejected %lld  %.1f MB", now.p50_us / 1000.0,
                 now.p99_us / 1000.0, static_cast<long long>(losses_of(now).rejected),
                 static_cast<double>(now.rss_bytes) / 1e6);
  if (now.degraded) line += "  DEGRADED";
  if (!now.note.empty()) line += "  (" + now.note + ")";
  return line;
}

std::string map_line(const Map& map) {
  const auto objects = [&](ObjectType type) {
    return std::ranges::count(map.objects, type, &Object::type);
  };
  // A corner is the meeting of two connected ends, or a lone point.
  const auto corners = [&](PointProperty property) {
    return std::ranges::count_if(map.points, [&](const Point& p) {
      const bool counted_by_the_other_end =
          p.connected != kNone && p.connected < &p - &map.points[0];
      return p.property == property && !counted_by_the_other_end;
    });
  };
  return format(
      "map       %lld walls, %lld concave and %lld convex corners, %lld doors, "
      "%lld possible doors",
      static_cast<long long>(objects(ObjectType::wall)),
      static_cast<long long>(corners(PointProperty::concave)),
      static_cast<long long>(corners(PointProperty::convex)),
      static_cast<long long>(objects(ObjectType::door)),
      static_cast<long long>(objects(ObjectType::possible_door)));
}

std::string entrance_line(const pico::entrance_t& entrance) {
  std::string line = "entrance  none found";
  if (entrance.entrance_found != 0) {
    line = format("entrance  %.2f m at %.0f deg, %.2f m wide",
                  std::hypot(entrance.middle_x, entrance.middle_y),
                  std::atan2(entrance.middle_y, entrance.middle_x) * 180.0 / std::numbers::pi,
                  entrance.width);
  }
  if (entrance.in_hallway != 0)
    line += format("; in a hallway %.2f m wide", entrance.hallway_width);
  return line;
}

std::string nearest_line(const pico::proximity_t& proximity) {
  if (!std::isfinite(proximity.nearest_distance)) return "nearest   nothing seen";
  const bool too_close = std::ranges::any_of(proximity.too_close, [](auto b) { return b != 0; });
  return format("nearest   %.2f m at %.0f deg%s", proximity.nearest_distance,
                proximity.nearest_bearing * 180.0 / std::numbers::pi,
                too_close ? ", TOO CLOSE" : "");
}

std::string place_line(const pico::world_position_t& position) {
  const std::string where =
      format("%.2f %.2f m, %.0f deg", position.robot_in_world.x, position.robot_in_world.y,
             position.robot_in_world.a * 180.0 / std::numbers::pi);
  if (position.state == pico::world_position_t::TRACKING) {
    const double sigma = std::sqrt(position.covariance[0] + position.covariance[4]);
    return "place     tracking at " + where + format(", within %.3f m", sigma);
  }
  std::string line = position.state == pico::world_position_t::LOST ? "place     lost, searching"
                                                                    : "place     searching";
  if (position.guessed != 0) line += "; perhaps at " + where;
  if (position.ambiguous != 0) line += format("; ambiguous among %d places", position.places);
  return line;
}

}  // namespace

void Board::take(const pico::status_t& status) {
  Seen& seen = seen_[status.component];
  if (!seen.now.component.empty()) seen.before = seen.now;
  seen.now = status;
}

std::vector<std::string> Board::lines() const {
  std::vector<const Seen*> order;
  for (const auto& [name, seen] : seen_) order.push_back(&seen);
  std::ranges::stable_sort(order, {}, [](const Seen* s) { return rank(s->now.component); });

  std::vector<std::string> lines;
  for (const Seen* seen : order) lines.push_back(component_line(seen->now, seen->before));
  if (map_) lines.push_back(map_line(to_model(*map_)));
  if (position_) lines.push_back(place_line(*position_));
  if (entrance_) lines.push_back(entrance_line(*entrance_));
  if (proximity_) lines.push_back(nearest_line(*proximity_));
  return lines;
}

}  // namespace perceptor
