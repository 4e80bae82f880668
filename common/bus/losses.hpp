/// @file What a component's STATUS says of the messages that it did not get to use.
#pragma once

#include <cstdint>

#include <pico/status_t.hpp>

namespace perceptor {

/// Over all inputs, since the process started.
struct Losses {
  std::int64_t rejected = 0;  ///< messages turned down
  std::int64_t missed = 0;    ///< sequence numbers that never came
};

inline Losses losses_of(const pico::status_t& status) {
  Losses losses;
  for (const auto& input : status.inputs) {
    losses.rejected += input.rejected;
    losses.missed += input.missed;
  }
  return losses;
}

}  // namespace perceptor
