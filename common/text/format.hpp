/// @file snprintf into a string.
#pragma once

#include <array>
#include <cstdio>
#include <string>

namespace perceptor {

/// What is beyond 400 characters is cut off.
template <class... Values>
std::string format(const char* pattern, Values... values) {
  std::array<char, 400> text{};
  std::snprintf(text.data(), text.size(), pattern, values...);
  return text.data();
}

}  // namespace perceptor
