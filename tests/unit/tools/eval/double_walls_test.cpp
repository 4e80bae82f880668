#include "tools/eval/double_walls.hpp"

#include <gtest/gtest.h>

#include "tests/unit/tools/eval/walls.hpp"

namespace perceptor {
namespace {

constexpr std::int64_t kSecond = 1'000'000;
constexpr std::int64_t kNow = 100 * kSecond;

std::size_t doubles_of(const Segment& first, const Segment& second,
                       std::int64_t second_seen = kNow) {
  Map map;
  testing::add_wall(map, first, kNow);
  testing::add_wall(map, second, second_seen);
  return count_double_walls(map, kNow, {});
}

const Segment kWall{{0.0, 0.0}, {2.0, 0.0}};

TEST(DoubleWalls, OneBehindTheOther) {
  EXPECT_EQ(doubles_of(kWall, {{1.0, 0.2}, {3.0, 0.2}}), 1U);
  EXPECT_EQ(doubles_of({{1.0, 0.2}, {3.0, 0.2}}, kWall), 1U);
}

TEST(DoubleWalls, PiecesOfOneLineAreNone) {
  EXPECT_EQ(doubles_of(kWall, {{1.0, 0.0}, {3.0, 0.0}}), 0U);
}

TEST(DoubleWalls, AlongsideForMoreThanAJoint) {
  EXPECT_EQ(doubles_of(kWall, {{1.75, 0.1}, {3.0, 0.1}}), 0U);
  EXPECT_EQ(doubles_of(kWall, {{1.65, 0.1}, {3.0, 0.1}}), 1U);
}

TEST(DoubleWalls, ThoseFartherApartAreTwo) {
  EXPECT_EQ(doubles_of(kWall, {{0.0, 0.35}, {2.0, 0.35}}), 0U);
}

TEST(DoubleWalls, OneMayLeanOnTheOther) {
  // 0.08 rad, about 5 degrees, then 0.25 rad, about 14.
  EXPECT_EQ(doubles_of(kWall, {{0.0, 0.02}, {2.0, 0.18}}), 1U);
  EXPECT_EQ(doubles_of(kWall, {{0.5, 0.0}, {1.5, 0.25}}), 0U);
}

TEST(DoubleWalls, TheDistanceIsThatInTheMiddleOfTheOverlap) {
  // It leaves the first one's line far beyond its end, where it does not matter.
  EXPECT_EQ(doubles_of(kWall, {{0.0, 0.1}, {9.0, 1.0}}), 1U);
}

TEST(DoubleWalls, TwoFacesOfOnePartitionAreNone) {
  EXPECT_EQ(doubles_of(kWall, {{2.0, -0.1}, {0.0, -0.1}}), 0U);
}

TEST(DoubleWalls, TheFreeSideCountsNotTheOrderOfTheEnds) {
  Map map;
  testing::add_wall(map, kWall, kNow);
  testing::add_wall(map, {{2.0, 0.1}, {0.0, 0.1}}, kNow).free_side = FreeSide::right;
  EXPECT_EQ(count_double_walls(map, kNow, {}), 1U);
  map.objects.back().free_side = FreeSide::unknown;
  EXPECT_EQ(count_double_walls(map, kNow, {}), 0U);
}

TEST(DoubleWalls, BothWereSeenOfLate) {
  const Segment beside{{0.0, 0.1}, {2.0, 0.1}};
  EXPECT_EQ(doubles_of(kWall, beside, kNow - 29 * kSecond), 1U);
  EXPECT_EQ(doubles_of(kWall, beside, kNow - 31 * kSecond), 0U);
  EXPECT_EQ(doubles_of(kWall, beside, 0), 0U) << "nobody knows when";
}

TEST(DoubleWalls, EveryPairCounts) {
  Map map;
  for (const double y : {0.0, 0.1, 0.2}) testing::add_wall(map, {{0.0, y}, {2.0, y}}, kNow);
  EXPECT_EQ(count_double_walls(map, kNow, {}), 3U);
}

}  // namespace
}  // namespace perceptor
