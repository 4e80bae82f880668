/// @file The commands of a driver, checked, for a source that has a robot to drive.
///
/// in: CMD_VELOCITY, CMD_OPEN_DOOR, CMD_SPEAK
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "common/bus/bus.hpp"
#include "common/geometry/twist.hpp"

namespace perceptor {

/// What is done about each.
struct DriverCommands {
  /// A wished velocity, resting on what was measured at `measured_at` [us] (none: just now).
  std::function<void(const Twist& wished, std::optional<std::int64_t> measured_at)> drive;
  /// Asks for a door; none: the nearest.
  std::function<void(std::optional<int> door)> open_door;
  std::function<void(const std::string& text)> speak;
};

/// A velocity of another session than `session` is turned down: it rests on what another robot
/// measured, or another run of this one. The bus must not outlive what the commands are done to.
void subscribe(Bus& bus, std::int64_t session, DriverCommands commands);

}  // namespace perceptor
