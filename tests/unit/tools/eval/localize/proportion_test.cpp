#include "tools/eval/localize/proportion.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace perceptor {
namespace {

TEST(ClopperPearson, AsInTables) {
  // Of C. J. Clopper and E. S. Pearson, 1934, and every textbook since.
  const ConfidenceInterval none = clopper_pearson({0, 10});
  EXPECT_DOUBLE_EQ(none.low, 0.0);
  EXPECT_NEAR(none.high, 0.3085, 1e-4);
  const ConfidenceInterval half = clopper_pearson({5, 10});
  EXPECT_NEAR(half.low, 0.1871, 1e-4);
  EXPECT_NEAR(half.high, 0.8129, 1e-4);
  EXPECT_DOUBLE_EQ(clopper_pearson({10, 10}).high, 1.0);
}

TEST(ClopperPearson, NothingIsKnownWithoutCases) {
  EXPECT_DOUBLE_EQ(clopper_pearson({}).low, 0.0);
  EXPECT_DOUBLE_EQ(clopper_pearson({}).high, 1.0);
  EXPECT_TRUE(std::isnan(Proportion{}.share()));
}

}  // namespace
}  // namespace perceptor
