/// @file A progress bar for people: on standard error, only on a terminal, only where the work
/// takes longer than a blink.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace perceptor {

class Progress {
 public:
  Progress(std::string what, std::int64_t total);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Draws at most ten times a second.
  void at(std::int64_t done);

 private:
  std::string what_;
  std::int64_t total_;
  bool on_terminal_;
  bool drawn_ = false;
  std::int64_t calls_ = 0;
  std::chrono::steady_clock::time_point started_;
  std::chrono::steady_clock::time_point last_drawn_;
};

}  // namespace perceptor
