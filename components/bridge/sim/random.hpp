/// @file Random numbers of the simulator: one seed, and a stream of its own for each thing that
/// is random, so that switching one on does not change the others.
#pragma once

#include <cstdint>
#include <random>

namespace perceptor::sim {

enum class Stream : std::uint32_t {
  slip_scale = 1,
  slip_walk,
  encoder_noise,
  range_noise,
  outliers,
  missed_beams,
  missed_values,
  gait
};

using Random = std::mt19937_64;

/// The stream of one thing.
Random make_stream(std::uint64_t seed, Stream stream);

}  // namespace perceptor::sim
