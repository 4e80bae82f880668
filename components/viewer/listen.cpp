#include "components/viewer/listen.hpp"

#include "common/bus/channels.hpp"

namespace perceptor::viewer {
namespace {

constexpr int kQueue = 100;  // seconds of scans, or the parts of a large map

template <class Message>
void listen_to(const char* name, Bus& bus, Newest& newest) {
  bus.subscribe_command<Message>(name, kQueue,
                                 [&newest](const Message& message) { newest.take(message); });
}

}  // namespace

void listen(Bus& bus, Newest& newest) {
  listen_to<pico::laser_scan_t>(channel::laser, bus, newest);
  listen_to<pico::position_t>(channel::position, bus, newest);
  listen_to<pico::proximity_t>(channel::proximity, bus, newest);
  listen_to<pico::entrance_t>(channel::entrance, bus, newest);
  listen_to<pico::world_position_t>(channel::world_position, bus, newest);
  listen_to<pico::truth_t>(channel::truth, bus, newest);
  for (const char* name : {channel::current_map, channel::local_map, channel::identified_map,
                           channel::global_map, channel::combined_map, channel::world})
    bus.subscribe_command<pico::map_t>(
        name, kQueue, [name, &newest](const pico::map_t& map) { newest.take(name, map); });
}

}  // namespace perceptor::viewer
