#include "tools/eval/room_random.hpp"

#include <cmath>
#include <numbers>

namespace perceptor {
namespace {

/// In [0, 1): the 53 upper bits, as many as a double holds.
double unit_uniform(RoomRandom& random) { return static_cast<double>(random() >> 11U) * 0x1p-53; }

}  // namespace

RoomRandom make_room_stream(std::uint64_t seed, std::uint64_t scan, RoomStream stream) {
  std::seed_seq sequence{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32U),
                         static_cast<std::uint32_t>(scan), static_cast<std::uint32_t>(scan >> 32U),
                         static_cast<std::uint32_t>(stream)};
  return RoomRandom(sequence);
}

double uniform(RoomRandom& random, double low, double high) {
  return low + (high - low) * unit_uniform(random);
}

int uniform_int(RoomRandom& random, int low, int high) {
  const int values = high - low + 1;
  return low + static_cast<int>(std::floor(values * unit_uniform(random)));
}

double uniform_angle(RoomRandom& random) {
  return uniform(random, -std::numbers::pi, std::numbers::pi);
}

bool happens(RoomRandom& random, double share) { return unit_uniform(random) < share; }

double normal(RoomRandom& random) {
  const double radius = std::sqrt(-2.0 * std::log(1.0 - unit_uniform(random)));
  const double turn = 2.0 * std::numbers::pi * unit_uniform(random);
  return radius * std::cos(turn);
}

}  // namespace perceptor
