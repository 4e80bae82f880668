/// @file What it costs that no message is trusted: the check of raw bytes and the validation,
/// beside the generated decode.
#include <cmath>
#include <vector>

#include <benchmark/benchmark.h>

#include "common/messages/convert.hpp"
#include "common/messages/schema.hpp"
#include "common/messages/validate.hpp"
#include "tests/bench/row_of_rooms.hpp"

namespace perceptor {
namespace {

pico::laser_scan_t laser_message() {
  pico::laser_scan_t scan{};
  scan.utime = 1;
  scan.num_ranges = 1000;
  scan.angle_min = -2.0;
  scan.angle_max = 2.0;
  scan.angle_increment = 4.0 / (scan.num_ranges - 1);
  scan.valid_min = 0.1;
  scan.valid_max = 10.0;
  scan.range_sigma = 0.01;
  for (int i = 0; i < scan.num_ranges; ++i)
    scan.ranges.push_back(2.0F + std::sin(0.01F * static_cast<float>(i)));
  return scan;
}

/// 100 walls.
pico::map_t map_message() { return make_map_message("robot", row_of_rooms(100)); }

template <class Message>
std::vector<std::uint8_t> encoded(const Message& message) {
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(message.getEncodedSize()));
  message.encode(bytes.data(), 0, static_cast<int>(bytes.size()));
  return bytes;
}

template <class Message>
void Decode(benchmark::State& state, const Message& message) {
  const std::vector<std::uint8_t> bytes = encoded(message);
  for (auto _ : state) {
    Message decoded;
    benchmark::DoNotOptimize(decoded.decode(bytes.data(), 0, static_cast<int>(bytes.size())));
  }
}
BENCHMARK_CAPTURE(Decode, laser, laser_message());
BENCHMARK_CAPTURE(Decode, map, map_message());

template <class Message>
void RawCheck(benchmark::State& state, const Message& message) {
  const std::vector<std::uint8_t> bytes = encoded(message);
  for (auto _ : state) benchmark::DoNotOptimize(messages::find_fault<Message>(bytes));
}
BENCHMARK_CAPTURE(RawCheck, laser, laser_message());
BENCHMARK_CAPTURE(RawCheck, map, map_message());

template <class Message>
void Validate(benchmark::State& state, const Message& message) {
  if (!messages::validate(message).empty()) state.SkipWithError("the sample is no good");
  for (auto _ : state) benchmark::DoNotOptimize(messages::validate(message));
}
BENCHMARK_CAPTURE(Validate, laser, laser_message());
BENCHMARK_CAPTURE(Validate, map, map_message());

}  // namespace
}  // namespace perceptor
