#include "components/bridge/velocity_command.hpp"

#include <gtest/gtest.h>

namespace perceptor {
namespace {

constexpr std::int64_t kSecond = 1'000'000;

TEST(WithinLimits, ASlowWishStaysAsItIs) {
  const Twist allowed = within_limits({0.3, -0.4, -1.2}, 0.5, 1.2);
  EXPECT_EQ(allowed.vx, 0.3);
  EXPECT_EQ(allowed.vy, -0.4);
  EXPECT_EQ(allowed.va, -1.2);
}

TEST(WithinLimits, AFastOneKeepsItsDirection) {
  const Twist allowed = within_limits({3.0, -4.0, 9.0}, 0.5, 1.2);
  EXPECT_DOUBLE_EQ(allowed.vx, 0.3);
  EXPECT_DOUBLE_EQ(allowed.vy, -0.4);
  EXPECT_EQ(allowed.va, 1.2);
}

TEST(VelocityCommand, CountsForItsLifetime) {
  VelocityCommand command(0.3);
  EXPECT_FALSE(command.has_come());
  EXPECT_FALSE(command.at(0));
  command.take({0.4, 0.0, 0.0}, 5 * kSecond);
  EXPECT_TRUE(command.has_come());
  ASSERT_TRUE(command.at(5 * kSecond + 300'000));
  EXPECT_EQ(command.at(5 * kSecond + 300'000)->vx, 0.4);
  EXPECT_FALSE(command.at(5 * kSecond + 300'001));
}

TEST(VelocityCommand, TheNewestCounts) {
  VelocityCommand command(0.3);
  command.take({0.4, 0.0, 0.0}, kSecond);
  command.take({0.1, 0.0, 0.0}, kSecond - 200'000);
  EXPECT_EQ(command.at(kSecond)->vx, 0.1);
  EXPECT_FALSE(command.at(kSecond + 200'000)) << "it rests on an older measurement";
}

}  // namespace
}  // namespace perceptor
