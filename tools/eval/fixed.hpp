/// @file Numbers as text, with so many decimals.
#pragma once

#include <cstdio>
#include <string>

namespace perceptor {

inline std::string fixed(double value, int decimals) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

}  // namespace perceptor
