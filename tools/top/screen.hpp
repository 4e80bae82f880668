/// @file The terminal as a screen of rows, by ncurses. In a file of its own: the names of ncurses
/// are macros, and one of them is that of a constant of ours.
#pragma once

#include <vector>

#include "tools/top/row.hpp"

namespace perceptor {

/// The terminal belongs to it while it lives, and is given back as it was.
class Screen {
 public:
  Screen();
  ~Screen();
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;

  /// As many rows as there is room for, and a line of help below.
  static void show(const std::vector<Row>& rows);

  /// Somebody pressed q.
  static bool wants_to_end();
};

}  // namespace perceptor
