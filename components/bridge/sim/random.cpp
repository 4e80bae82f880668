#include "components/bridge/sim/random.hpp"

namespace perceptor::sim {

Random make_stream(std::uint64_t seed, Stream stream) {
  std::seed_seq sequence{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32U),
                         static_cast<std::uint32_t>(stream)};
  return Random(sequence);
}

}  // namespace perceptor::sim
