/// @file Random worlds as the files that the simulator reads: a map and what it adds to one.
#pragma once

#include <filesystem>
#include <string>

#include "tools/eval/random_world.hpp"

namespace perceptor {

/// Writes `folder`/maps/`name`.json and `folder`/worlds/`name`.json, the folders made where they
/// are missing. Coordinates are rounded to millimetres. Throws std::runtime_error where a file
/// cannot be written.
void write_random_world(const RandomWorld& world, const RandomWorldParameters& parameters,
                        std::size_t number, const std::filesystem::path& folder,
                        const std::string& name);

}  // namespace perceptor
