/// @file A line of a table in the terminal.
#pragma once

#include <string>

namespace perceptor {

struct Row {
  std::string text;
  enum class Look { plain, title, alarm } look = Look::plain;
};

}  // namespace perceptor
