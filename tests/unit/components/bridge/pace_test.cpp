#include "components/bridge/pace.hpp"

#include <gtest/gtest.h>

namespace perceptor {
namespace {

constexpr std::int64_t second = 1'000'000;

TEST(Pace, FollowsTheClockTimesTheSpeed) {
  Pace pace(4.0, 10 * second);
  const std::int64_t start = 777;
  EXPECT_EQ(pace.source_time(start, 10 * second), 10 * second);
  EXPECT_EQ(pace.source_time(start + (second / 2), 12 * second), 12 * second);
  EXPECT_EQ(pace.clock_time(14 * second, start), start + second);
  EXPECT_EQ(pace.clock_time(10 * second, start + 5), start + 5);
  EXPECT_EQ(pace.lost(), 0);
}

TEST(Pace, ASourceThatCannotKeepUpFallsBehind) {
  Pace pace(1.0, 0);
  pace.source_time(0, 0);
  // What was due at 1 s is still to come at 3 s: the source goes on from 1 s.
  EXPECT_EQ(pace.source_time(3 * second, second), second);
  EXPECT_EQ(pace.lost(), 2 * second);
  EXPECT_EQ(pace.source_time(4 * second, 2 * second), 2 * second);
  EXPECT_EQ(pace.lost(), 2 * second);
}

TEST(Pace, ForgivesAHiccup) {
  Pace pace(1.0, 0);
  pace.source_time(0, 0);
  EXPECT_EQ(pace.source_time(second + 90'000, second), second + 90'000);
  EXPECT_EQ(pace.lost(), 0);
}

TEST(Pace, SpeedZeroIsAsFastAsItCan) {
  Pace pace(0.0, 0);
  EXPECT_GT(pace.source_time(5, 0), 1'000'000 * second);
  EXPECT_EQ(pace.clock_time(1000 * second, 5), 5);
}

}  // namespace
}  // namespace perceptor
