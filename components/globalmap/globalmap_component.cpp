#include "components/globalmap/globalmap_component.hpp"

#include <chrono>

#include "common/bus/channels.hpp"
#include "common/config/named_file.hpp"
#include "common/floorplan/floorplan.hpp"
#include "common/messages/convert.hpp"
#include "common/time/stamp.hpp"

namespace perceptor {
namespace {

constexpr std::int64_t kPeriod = kMicrosecondsPerSecond;

std::int64_t wall_now() {
  return std::chrono::duration_cast<std::chrono::microseconds>(
             std::chrono::system_clock::now().time_since_epoch())
      .count();
}

Floorplan read(const GlobalmapConfig& config, Bus& bus) {
  Floorplan plan =
      read_floorplan(config::find_named("map", config.map, config.config_dir / "maps"));
  for (const std::string& pointer : plan.ignored)
    bus.count(channel::global_map, "ignored in the file: " + pointer, 1);
  return plan;
}

}  // namespace

void describe(config::Fields& fields, GlobalmapConfig& config) {
  global_map::GlobalMapParameters& p = config.global_map;
  fields.text("map", config.map, "the building: a name in the folder maps, or a JSON file");
  fields.number("snap", p.free_space.snap, {1e-6, 1.0},
                "[m] points nearer than this are one; larger closes chains drawn with gaps");
  fields.number("min_width", p.free_space.min_width, {0.0, 10.0},
                "[m] a narrower closed space is the inside of a wall");
  fields.number("max_opening", p.free_space.max_opening, {0.0, 100.0},
                "[m] wider gaps do not tell inside from outside");
  fields.number("straight_angle", p.straight_angle, {0.0, 1.5},
                "[rad] walls that turn by less are no corner");
}

GlobalmapComponent::GlobalmapComponent(const GlobalmapConfig& config, Bus& bus)
    : bus_(bus), session_(wall_now()) {
  try {
    const global_map::GlobalMap global =
        global_map::make_global_map(read(config, bus), config.global_map);
    parts_ = make_map_messages("world", global.map, global.id);
  } catch (const global_map::TooManyCrossings& error) {
    throw config::Error(config.map + ": " + error.what());
  }
}

std::int64_t GlobalmapComponent::step(std::int64_t now) {
  if (now < next_) return next_;
  const std::int64_t utime = wall_now();
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    set_stamp(parts_[i], {utime + static_cast<std::int64_t>(i), session_, seq_++});
    bus_.publish(channel::global_map, parts_[i]);
  }
  next_ = now + kPeriod;
  return next_;
}

}  // namespace perceptor
