/// @file Files that people call by name: worlds, maps.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace perceptor::config {

/// Finds a JSON file by its path, or by its name in a folder ("hospital", "hospital.json"). `kind`
/// is what it is called ("world"), and the key that names it. Throws Error, which lists those there
/// are.
std::filesystem::path find_named(std::string_view kind, const std::string& name,
                                 const std::filesystem::path& folder);

}  // namespace perceptor::config
