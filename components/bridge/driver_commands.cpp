#include "components/bridge/driver_commands.hpp"

#include <utility>

#include <pico/open_door_t.hpp>
#include <pico/speak_t.hpp>
#include <pico/velocity_t.hpp>

#include "common/bus/channels.hpp"

namespace perceptor {
namespace {

/// Commands that may wait: the newest of them counts.
constexpr int kCapacity = 20;

template <class Value>
std::optional<Value> where(bool is_given, const Value& value) {
  return is_given ? std::optional(value) : std::nullopt;
}

}  // namespace

void subscribe(Bus& bus, std::int64_t session, DriverCommands commands) {
  bus.subscribe_command<pico::velocity_t>(
      channel::velocity, kCapacity,
      [&bus, session, drive = std::move(commands.drive)](const pico::velocity_t& command) {
        const bool is_of_another_session = command.session != 0 && command.session != session;
        if (is_of_another_session) return bus.reject(channel::velocity, "of another session");
        drive({command.vx, command.vy, command.va}, where(command.utime != 0, command.utime));
      });
  bus.subscribe_command<pico::open_door_t>(
      channel::open_door, kCapacity,
      [open_door = std::move(commands.open_door)](const pico::open_door_t& request) {
        open_door(where<int>(request.door >= 0, request.door));
      });
  bus.subscribe_command<pico::speak_t>(
      channel::speak, kCapacity,
      [speak = std::move(commands.speak)](const pico::speak_t& speech) { speak(speech.text); });
}

}  // namespace perceptor
