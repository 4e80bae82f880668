#include "common/messages/schema.hpp"

#include <algorithm>
#include <limits>
#include <ostream>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "tests/support/allocation_watch.hpp"
#include "tests/support/message_samples.hpp"

namespace perceptor::messages {
namespace {

constexpr std::int32_t kLargest = std::numeric_limits<std::int32_t>::max();
constexpr std::int32_t kSmallest = std::numeric_limits<std::int32_t>::min();

void write_at(Bytes& bytes, std::size_t offset, std::int32_t value) {
  for (std::size_t i = 0; i < 4; ++i)
    bytes.at(offset + i) =
        static_cast<std::uint8_t>(static_cast<std::uint32_t>(value) >> (24U - 8U * i));
}

template <class Message>
class FindFault : public testing::Test {};

using Messages = testing::Types<pico::laser_scan_t, pico::odometry_t, pico::sonar_t,
                                pico::velocity_t, pico::open_door_t, pico::speak_t, pico::truth_t,
                                pico::position_t, pico::proximity_t, pico::map_t, pico::entrance_t,
                                pico::world_position_t, pico::status_t>;

struct TypeName {
  template <class Message>
  static std::string GetName(int) {
    return Message::getTypeName();
  }
};

TYPED_TEST_SUITE(FindFault, Messages, TypeName);

TYPED_TEST(FindFault, FindsNoneInAGoodMessage) {
  EXPECT_EQ(find_fault<TypeParam>(encoded(sample<TypeParam>())), "");
  EXPECT_EQ(find_fault<TypeParam>(encoded(TypeParam{})), "") << "with nothing in its arrays";
}

TYPED_TEST(FindFault, FindsTruncationAtEveryLength) {
  const Bytes good = encoded(sample<TypeParam>());
  for (std::size_t size = 0; size < good.size(); ++size) {
    const Bytes cut(good.begin(), good.begin() + static_cast<std::ptrdiff_t>(size));
    EXPECT_NE(find_fault<TypeParam>(cut), "") << size << " of " << good.size();
  }
}

TYPED_TEST(FindFault, FindsBytesLeftOver) {
  Bytes bytes = encoded(sample<TypeParam>());
  bytes.push_back(0);
  EXPECT_EQ(find_fault<TypeParam>(bytes), "bytes left over");
  bytes.insert(bytes.end(), 1000, 0xFF);
  EXPECT_EQ(find_fault<TypeParam>(bytes), "bytes left over");
}

TYPED_TEST(FindFault, FindsAnotherFingerprint) {
  const Bytes good = encoded(sample<TypeParam>());
  for (std::size_t i = 0; i < 8; ++i) {
    Bytes other = good;
    other[i] ^= 1U;
    EXPECT_EQ(find_fault<TypeParam>(other), "another type");
  }
}

/// Each hostile number at each offset hits every count and every string's length.
TYPED_TEST(FindFault, LetsNoHostileNumberThroughToTheDecode) {
  const Bytes good = encoded(sample<TypeParam>());
  test::forget_allocations();
  for (std::size_t offset = 8; offset + 4 <= good.size(); ++offset) {
    for (const std::int32_t hostile : {-1, kSmallest, 0x20000000, kLargest, 100'000'000, 65'536}) {
      Bytes bytes = good;
      write_at(bytes, offset, hostile);
      if (!find_fault<TypeParam>(bytes).empty()) continue;
      const int size = static_cast<int>(bytes.size());
      TypeParam message;
      ASSERT_EQ(message.decode(bytes.data(), 0, size), size) << offset << ": " << hostile;
      validate(message);
    }
  }
  EXPECT_LT(test::largest_allocation(), 100'000U);
}

TEST(FindFault, KnowsEveryType) {
#define PICO_TYPE(type)                                                  \
  EXPECT_EQ(find_fault<pico::type>(encoded(pico::type{})), "") << #type; \
  EXPECT_EQ(type_info<pico::type>()->get_hash(), pico::type::getHash()) << #type;
#include <pico/all_types.inc>
#undef PICO_TYPE
}

TEST(FindFault, NoTwoTypesHaveOneFingerprint) {
  std::vector<std::int64_t> hashes;
#define PICO_TYPE(type) hashes.push_back(pico::type::getHash());
#include <pico/all_types.inc>
#undef PICO_TYPE
  std::ranges::sort(hashes);
  EXPECT_EQ(std::ranges::adjacent_find(hashes), hashes.end());
}

TEST(FindFault, NoTypeIsAFault) {
  EXPECT_EQ(find_fault(nullptr, Bytes(100)), "unknown type");
  const lcm_type_info_t foreign = *type_info<pico::pose_t>();
  EXPECT_EQ(find_fault(&foreign, Bytes(100)), "unknown type");
}

/// A message with `length` elements in one of its arrays and few in the others.
struct ArrayCase {
  std::string name;
  Bytes (*message)(std::int32_t length);
  const lcm_type_info_t* type;

  friend void PrintTo(const ArrayCase& array, std::ostream* out) { *out << array.name; }
};

template <class Message>
ArrayCase array_case(std::string name, Bytes (*message)(std::int32_t)) {
  return {std::move(name), message, type_info<Message>()};
}

/// A length that no other number in the messages has.
constexpr std::int32_t kMarkedLength = 0x1357;

std::size_t offset_of_mark(const Bytes& bytes) {
  Bytes mark(4);
  write_at(mark, 0, kMarkedLength);
  const auto found = std::ranges::search(bytes, mark);
  EXPECT_FALSE(found.empty());
  EXPECT_TRUE(std::ranges::search(found.end(), bytes.end(), mark.begin(), mark.end()).empty());
  return static_cast<std::size_t>(found.begin() - bytes.begin());
}

template <class Item>
void fill(std::int32_t& count, std::vector<Item>& items, std::int32_t length) {
  count = length;
  items.resize(static_cast<std::size_t>(length));
}

class EachArray : public testing::TestWithParam<ArrayCase> {};

TEST_P(EachArray, HasItsLengthChecked) {
  const Bytes good = GetParam().message(kMarkedLength);
  ASSERT_EQ(find_fault(GetParam().type, good), "");
  const std::size_t offset = offset_of_mark(good);
  const auto fault_with = [&](std::int32_t length) {
    Bytes bytes = good;
    write_at(bytes, offset, length);
    return find_fault(GetParam().type, bytes);
  };
  EXPECT_EQ(fault_with(-1), "negative length");
  EXPECT_EQ(fault_with(kSmallest), "negative length");
  EXPECT_EQ(fault_with(0x20000000), "length beyond the message");
  EXPECT_EQ(fault_with(kLargest), "length beyond the message");
}

INSTANTIATE_TEST_SUITE_P(
    OfEachType, EachArray,
    testing::Values(array_case<pico::laser_scan_t>("scan_ranges",
                                                   [](std::int32_t length) {
                                                     auto scan = sample<pico::laser_scan_t>();
                                                     fill(scan.num_ranges, scan.ranges, length);
                                                     return encoded(scan);
                                                   }),
                    array_case<pico::laser_scan_t>("scan_bearings",
                                                   [](std::int32_t length) {
                                                     auto scan = sample<pico::laser_scan_t>();
                                                     fill(scan.num_bearings, scan.bearings, length);
                                                     return encoded(scan);
                                                   }),
                    array_case<pico::sonar_t>("sonars",
                                              [](std::int32_t length) {
                                                auto sonar = sample<pico::sonar_t>();
                                                fill(sonar.num_sonars, sonar.distances, length);
                                                fill(sonar.num_sonars, sonar.sonar_in_robot,
                                                     length);
                                                return encoded(sonar);
                                              }),
                    array_case<pico::truth_t>("truth_doors",
                                              [](std::int32_t length) {
                                                auto truth = sample<pico::truth_t>();
                                                fill(truth.num_doors, truth.doors, length);
                                                return encoded(truth);
                                              }),
                    array_case<pico::truth_t>("truth_movers",
                                              [](std::int32_t length) {
                                                auto truth = sample<pico::truth_t>();
                                                fill(truth.num_movers, truth.movers, length);
                                                return encoded(truth);
                                              }),
                    array_case<pico::proximity_t>("sectors",
                                                  [](std::int32_t length) {
                                                    auto near = sample<pico::proximity_t>();
                                                    fill(near.num_sectors, near.too_close, length);
                                                    fill(near.num_sectors, near.blind, length);
                                                    fill(near.num_sectors, near.contact, length);
                                                    fill(near.num_sectors, near.distances, length);
                                                    fill(near.num_sectors, near.bearings, length);
                                                    return encoded(near);
                                                  }),
                    array_case<pico::map_t>("map_points",
                                            [](std::int32_t length) {
                                              auto map = sample<pico::map_t>();
                                              fill(map.num_points, map.points, length);
                                              return encoded(map);
                                            }),
                    array_case<pico::map_t>("map_objects",
                                            [](std::int32_t length) {
                                              auto map = sample<pico::map_t>();
                                              fill(map.num_objects, map.objects, length);
                                              return encoded(map);
                                            }),
                    array_case<pico::map_t>("map_parents",
                                            [](std::int32_t length) {
                                              auto map = sample<pico::map_t>();
                                              fill(map.points[2].num_parents, map.points[2].parents,
                                                   length);
                                              return encoded(map);
                                            }),
                    array_case<pico::map_t>("map_object_points",
                                            [](std::int32_t length) {
                                              auto map = sample<pico::map_t>();
                                              fill(map.objects[1].num_points, map.objects[1].points,
                                                   length);
                                              return encoded(map);
                                            }),
                    array_case<pico::status_t>("status_inputs",
                                               [](std::int32_t length) {
                                                 auto status = sample<pico::status_t>();
                                                 fill(status.num_inputs, status.inputs, length);
                                                 return encoded(status);
                                               }),
                    array_case<pico::status_t>("status_rejects",
                                               [](std::int32_t length) {
                                                 auto status = sample<pico::status_t>();
                                                 fill(status.num_rejects, status.rejects, length);
                                                 return encoded(status);
                                               }),
                    array_case<pico::status_t>("status_outputs",
                                               [](std::int32_t length) {
                                                 auto status = sample<pico::status_t>();
                                                 fill(status.num_outputs, status.outputs, length);
                                                 return encoded(status);
                                               })),
    [](const auto& suite) { return suite.param.name; });

/// The text of CMD_SPEAK: its length follows the fingerprint and the stamp.
constexpr std::size_t kTextLength = 8 + 3 * 8;

TEST(FindFault, AStringHasItsEndAndNothingBehindIt) {
  const Bytes good = encoded(sample<pico::speak_t>());
  const auto text_size = static_cast<std::int32_t>(good.size() - kTextLength - 4);
  const auto fault_with = [&good](std::int32_t length) {
    Bytes bytes = good;
    write_at(bytes, kTextLength, length);
    return find_fault<pico::speak_t>(bytes);
  };
  EXPECT_EQ(fault_with(text_size), "");
  EXPECT_EQ(fault_with(0), "string without its end");
  EXPECT_EQ(fault_with(-1), "string without its end");
  EXPECT_EQ(fault_with(kSmallest), "string without its end");
  EXPECT_EQ(fault_with(text_size - 1), "string without its end");
  EXPECT_EQ(fault_with(text_size + 1), "length beyond the message");
  EXPECT_EQ(fault_with(kLargest), "length beyond the message");

  Bytes zero_inside = good;
  zero_inside[kTextLength + 6] = 0;
  EXPECT_EQ(find_fault<pico::speak_t>(zero_inside), "string with a zero inside");
  Bytes no_end = good;
  no_end.back() = 'x';
  EXPECT_EQ(find_fault<pico::speak_t>(no_end), "string without its end");
}

TEST(FindFault, ABooleanIsZeroOrOne) {
  auto proximity = sample<pico::proximity_t>();
  for (auto* booleans : {&proximity.too_close, &proximity.blind, &proximity.contact}) {
    for (const int neither : {2, -1, 127}) {
      const std::int8_t kept = std::exchange(booleans->back(), static_cast<std::int8_t>(neither));
      EXPECT_EQ(find_fault<pico::proximity_t>(encoded(proximity)),
                "boolean that is neither 0 nor 1");
      booleans->back() = kept;
    }
  }
}

}  // namespace
}  // namespace perceptor::messages
