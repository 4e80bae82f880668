#include <gtest/gtest.h>

#include "common/config/nearest.hpp"

namespace perceptor::config {
namespace {

TEST(EditDistance, CountsEachKindOfSlip) {
  EXPECT_EQ(edit_distance("speed", "speed"), 0U);
  EXPECT_EQ(edit_distance("sped", "speed"), 1U);    // one is missing
  EXPECT_EQ(edit_distance("speeed", "speed"), 1U);  // one too many
  EXPECT_EQ(edit_distance("spead", "speed"), 1U);   // another one
  EXPECT_EQ(edit_distance("psede", "speed"), 2U);   // swapped, twice
  EXPECT_EQ(edit_distance("", "speed"), 5U);
  EXPECT_EQ(edit_distance("speed", ""), 5U);
  EXPECT_EQ(edit_distance("", ""), 0U);
}

TEST(EditDistance, IsSymmetric) {
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);
  EXPECT_EQ(edit_distance("sitting", "kitten"), 3U);
}

TEST(Nearest, PicksTheFirstOfTheBest) {
  EXPECT_EQ(nearest("max_sped", {"min_speed", "max_speed", "max_spend"}), "max_speed");
  EXPECT_EQ(nearest("x", {"a", "b"}), "a");
  EXPECT_EQ(nearest("x", {}), "");
}

}  // namespace
}  // namespace perceptor::config
