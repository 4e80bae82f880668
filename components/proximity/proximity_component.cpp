#include "components/proximity/proximity_component.hpp"

#include <cstdint>

#include <pico/laser_scan_t.hpp>
#include <pico/proximity_t.hpp>

#include "common/bus/channels.hpp"
#include "common/messages/convert.hpp"
#include "common/time/stamp.hpp"

namespace perceptor {
namespace {

/// A quarter of a second of scans: after a longer stall the warning should not be about
/// the past.
constexpr int kLaserCapacity = 10;

void set_surroundings(pico::proximity_t& message, const Surroundings& surroundings) {
  message.nearest_distance = surroundings.nearest_distance;
  message.nearest_bearing = surroundings.nearest_bearing;
  message.num_sectors = static_cast<std::int32_t>(surroundings.sectors.size());
  for (const Sector& sector : surroundings.sectors) {
    message.too_close.push_back(sector.too_close ? 1 : 0);
    message.blind.push_back(sector.blind ? 1 : 0);
    message.contact.push_back(sector.contact ? 1 : 0);
    message.distances.push_back(sector.distance);
    message.bearings.push_back(sector.bearing);
  }
}

}  // namespace

void describe(config::Fields& fields, ProximityConfig& config) {
  ProximityParameters& p = config.proximity;
  fields.number("radius", p.radius, {0.0, 100.0},
                "[m] from the robot's centre; what is closer is too close");
  fields.integer(
      "num_sectors", p.num_sectors, {1, 120},
      "around the robot; narrower than 3 degrees, the robot's own last beams would fill one");
  fields.number("contact_share", p.contact_share, {0.01, 1.0},
                "share of a sector that a body inside the footprint covers to be a contact; less "
                "takes a sliver of the robot itself for a body");
  fields.integer("min_beams_for_seen", p.min_beams_for_seen, {1, 10000},
                 "a sector with fewer usable beams is blind");
  fields.group("robot", config.robot, "the robot itself");
}

ProximityComponent::ProximityComponent(const ProximityConfig& config, Bus& bus)
    : bus_(bus), parameters_(config.proximity), footprint_(outline(config.robot)) {
  bus_.subscribe<pico::laser_scan_t>(
      channel::laser, kLaserCapacity,
      [this](const pico::laser_scan_t& message, bool /*began_anew*/) { take(message); });
}

void ProximityComponent::take(const pico::laser_scan_t& message) {
  const LaserScan scan = to_model(message);
  const Surroundings surroundings = look_around(scan, footprint_, parameters_);

  const std::size_t without_return = scan.size() - count_returns(scan);
  bus_.count(channel::laser, "beam without return", static_cast<std::int64_t>(without_return));
  bus_.count(channel::laser, "beam on the robot itself", surroundings.own_beams);

  pico::proximity_t proximity{};
  set_stamp(proximity, stamp_of(message));
  proximity.radius = parameters_.radius;
  set_surroundings(proximity, surroundings);
  bus_.publish(channel::proximity, proximity);
}

}  // namespace perceptor
