#include "components/scan/scan_component.hpp"

#include <string>
#include <variant>

#include <pico/map_t.hpp>
#include <pico/position_t.hpp>

#include "common/bus/channels.hpp"
#include "common/messages/convert.hpp"
#include "components/scan/current_map.hpp"

namespace perceptor {
namespace {

/// Five seconds of scans at 40 Hz, so that a stall loses none.
constexpr int kLaserCapacity = 200;
/// Eight seconds of positions at 50 Hz: every one matters to the scans around it.
constexpr int kPositionCapacity = 400;

}  // namespace

ScanComponent::ScanComponent(const ScanConfig& config, Bus& bus)
    : bus_(bus), extractor_(config.scan, outline(config.robot)), aligner_(config.aligner) {
  bus_.subscribe<pico::laser_scan_t>(channel::laser, kLaserCapacity,
                                     [this](const pico::laser_scan_t& sweep, bool began_anew) {
                                       aligner_.add_item(stamp_of(sweep), began_anew, sweep);
                                       drain();
                                     });
  bus_.subscribe<pico::position_t>(channel::position, kPositionCapacity,
                                   [this](const pico::position_t& position, bool began_anew) {
                                     aligner_.add_position(stamp_of(position), began_anew,
                                                           position.zero_utime,
                                                           to_model(position.robot_in_zero));
                                     drain();
                                   });
}

void ScanComponent::finish() {
  while (const auto dropped = aligner_.abandon()) bus_.reject(channel::laser, dropped->reason);
}

void ScanComponent::drain() {
  while (const auto outcome = aligner_.next()) {
    if (const auto* paired = std::get_if<LaserAligner::Paired>(&*outcome))
      publish_map(*paired);
    else
      bus_.reject(channel::laser, std::get<LaserAligner::Dropped>(*outcome).reason);
  }
  if (aligner_.depends_on_arrival()) bus_.status().degrade("results depend on order of arrival");
}

void ScanComponent::publish_map(const LaserAligner::Paired& paired) {
  const scan::Extraction& found = extractor_.extract(to_model(paired.item), paired.position.twist);
  bus_.count(channel::laser, "beam without return", static_cast<std::int64_t>(found.no_return));
  bus_.count(channel::laser, "beam on the robot itself",
             static_cast<std::int64_t>(found.in_footprint));

  pico::map_t message =
      make_map_message("robot", scan::current_map(found, extractor_.parameters().corner));
  set_stamp(message, paired.stamp);
  message.map_id = paired.stamp.seq;
  message.zero_utime = paired.position.zero_utime;
  message.laser_in_robot = paired.item.laser_in_robot;
  message.robot_in_zero = to_message(paired.position.robot_in_zero);
  message.robot_in_local = message.robot_in_zero;
  bus_.publish(channel::current_map, message);
}

}  // namespace perceptor
