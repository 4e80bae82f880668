#include <algorithm>
#include <array>
#include <random>

#include <gtest/gtest.h>

#include "common/messages/convert.hpp"
#include "common/messages/schema.hpp"
#include "tests/support/allocation_watch.hpp"
#include "tests/support/message_samples.hpp"

namespace perceptor::messages {
namespace {

constexpr int kMutations = 10'000;

class Mutator {
 public:
  /// One to four changes of the kinds that broken and hostile senders make.
  Bytes mutated(Bytes bytes) {
    const std::size_t changes = 1 + below(4);
    for (std::size_t i = 0; i < changes && bytes.size() > 8; ++i) change(bytes);
    return bytes;
  }

 private:
  std::size_t below(std::size_t end) { return random_() % end; }

  void change(Bytes& bytes) {
    const std::size_t at = 8 + below(bytes.size() - 8);  // behind the fingerprint
    const auto place = bytes.begin() + static_cast<std::ptrdiff_t>(at);
    switch (below(6)) {
      case 0:
        *place = static_cast<std::uint8_t>(random_());
        break;
      case 1:
        *place ^= static_cast<std::uint8_t>(1U << below(8));
        break;
      case 2:
        bytes.erase(place);
        break;
      case 3:
        bytes.insert(place, static_cast<std::uint8_t>(below(3)));
        break;
      case 4: {  // a small whole number, as counts and indices are
        for (std::size_t i = at; i < std::min(at + 4, bytes.size()); ++i) bytes[i] = 0;
        bytes[std::min(at + 3, bytes.size() - 1)] = static_cast<std::uint8_t>(below(8));
        break;
      }
      default: {  // NaN, infinity, -1, a huge number
        constexpr std::array<std::uint8_t, 4> kBeginnings = {0x7F, 0xFF, 0x20, 0x80};
        *place = kBeginnings.at(below(kBeginnings.size()));
        for (std::size_t i = at + 1; i < std::min(at + 8, bytes.size()); ++i)
          bytes[i] = below(2) == 0 ? 0xFF : 0xF0;
      }
    }
  }

  std::mt19937_64 random_{1};
};

/// What is called valid has to bear being used.
template <class Message>
void use(const Message&) {}

template <>
void use(const pico::laser_scan_t& message) {
  const LaserScan scan = to_model(message);
  EXPECT_EQ(scan.bearings.size(), scan.ranges.size());
  for (const BeamEnd& end : beam_ends(scan, {0.5, 0.0, 1.2})) EXPECT_TRUE(end.location.allFinite());
}

template <>
void use(const pico::map_t& message) {
  Map map = to_model(message);
  EXPECT_EQ(find_broken_reference(transform(map, {1.0, 2.0, 3.0})), "");
  remove_objects(map);
  EXPECT_EQ(find_broken_reference(map), "");
  EXPECT_EQ(validate(make_map_message("robot", map)), "");
}

template <class Message>
void expect_survives_mutations() {
  SCOPED_TRACE(Message::getTypeName());
  const Bytes good = encoded(sample<Message>());
  Mutator mutator;
  int well_formed = 0;
  int valid = 0;
  test::forget_allocations();
  for (int i = 0; i < kMutations; ++i) {
    const Bytes bytes = mutator.mutated(good);
    if (!find_fault<Message>(bytes).empty()) continue;
    ++well_formed;
    const int size = static_cast<int>(bytes.size());
    Message message;
    ASSERT_EQ(message.decode(bytes.data(), 0, size), size);
    ASSERT_EQ(encoded(message), bytes) << "decoded to the last byte";
    if (!validate(message).empty()) continue;
    ++valid;
    use(message);
  }
  EXPECT_LT(test::largest_allocation(), 100'000U);
  EXPECT_GT(well_formed, valid) << "both checks had something to find";
  EXPECT_GT(valid, 0);
}

TEST(Mutation, NeitherCheckNorDecodeNorConversionFailsOnAnyMessage) {
  expect_survives_mutations<pico::laser_scan_t>();
  expect_survives_mutations<pico::odometry_t>();
  expect_survives_mutations<pico::sonar_t>();
  expect_survives_mutations<pico::velocity_t>();
  expect_survives_mutations<pico::open_door_t>();
  expect_survives_mutations<pico::speak_t>();
  expect_survives_mutations<pico::truth_t>();
  expect_survives_mutations<pico::position_t>();
  expect_survives_mutations<pico::proximity_t>();
  expect_survives_mutations<pico::map_t>();
  expect_survives_mutations<pico::entrance_t>();
  expect_survives_mutations<pico::world_position_t>();
  expect_survives_mutations<pico::status_t>();
}

}  // namespace
}  // namespace perceptor::messages
