/// @file What every source of the bridge has in common: it works by itself, step by step.
#pragma once

#include <cstdint>

namespace perceptor {

/// Publishes measurements on the bus that it was made with, and takes commands from it where it
/// has a robot to drive.
class Source {
 public:
  Source() = default;
  Source(const Source&) = delete;
  Source& operator=(const Source&) = delete;
  virtual ~Source() = default;

  /// Does what has become due by `now` [us, monotonic], though not more than a little at a time;
  /// gives when to be called next.
  virtual std::int64_t step(std::int64_t now) = 0;

  /// Nothing more will come.
  virtual bool finished() const = 0;

  /// The bridge ends: what moves is brought to rest, at once.
  virtual void stop() {}
};

}  // namespace perceptor
