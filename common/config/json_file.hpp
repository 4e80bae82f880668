/// @file Reads JSON strictly: bounded in size and nesting, no duplicate keys, no number that
/// overflows. For configuration and map files alike.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

namespace perceptor::config {

inline constexpr std::size_t kMaxFileSize = 4'000'000;  ///< [bytes] real files have some 10 kB
inline constexpr int kMaxNesting = 32;                  ///< real files nest 4 deep

/// Throws Error, which names the file, where it cannot be read, is larger than kMaxFileSize
/// (no more than that is ever read), or is refused by parse_json.
nlohmann::json read_json(const std::filesystem::path& file);

/// Throws Error, which names `source`, where the text nests deeper than kMaxNesting (seen
/// before parsing), is no JSON (with the line), repeats a key or holds a number beyond a
/// double's range (with the JSON pointer).
nlohmann::json parse_json(std::string_view text, const std::string& source);

}  // namespace perceptor::config
