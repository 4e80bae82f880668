/// @file `pico-eval rooms`: makes a set of scans in random rooms.
#pragma once

#include <filesystem>

#include <CLI/CLI.hpp>

#include "tools/eval/room_set.hpp"

namespace perceptor {

struct RoomsCommand {
  std::filesystem::path out;
  RoomScanParameters parameters;
};

/// The command line fills `command`, which has to live until it is parsed.
CLI::App* add_rooms_command(CLI::App& app, RoomsCommand& command);

/// Writes OUT.scan and OUT.truth; the exit code.
int run_rooms_command(const RoomsCommand& command);

}  // namespace perceptor
