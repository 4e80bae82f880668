/// @file Where in which input a value stands, and how a fault there is told.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "common/config/fields.hpp"

namespace perceptor::config {

struct Place {
  std::string source;   ///< a file's name, or "--set key=value"
  std::string pointer;  ///< JSON pointer (RFC 6901); empty: the whole document

  Place key(std::string_view name) const;
  Place item(std::size_t index) const;
};

/// Throws Error: the place, the value (cut where it is long), and what is allowed.
[[noreturn]] void fail(const Place& place, const nlohmann::json& value, std::string_view allowed);

/// Throws Error: the place and the problem.
[[noreturn]] void fail(const Place& place, std::string_view problem);

/// A value as JSON on one line, cut where it is long.
std::string excerpt(const nlohmann::json& value);

/// Text for a message, cut where it is long.
std::string cut(std::string_view text);

}  // namespace perceptor::config
