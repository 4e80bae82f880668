#include "common/time/continuity.hpp"

#include <gtest/gtest.h>

namespace perceptor {
namespace {

TEST(ContinuityWatch, GoesOnWhileTimeGoesForward) {
  ContinuityWatch watch;
  EXPECT_EQ(watch.check({100, 1, 0}), Continuity::began_anew);
  EXPECT_EQ(watch.check({200, 1, 1}), Continuity::continues);
  EXPECT_EQ(watch.restarts(), 0);
  EXPECT_EQ(watch.missed(), 0);
}

TEST(ContinuityWatch, DropsASmallStepBackAndARepetition) {
  ContinuityWatch watch;
  watch.check({10'000'000, 1, 0});
  EXPECT_EQ(watch.check({8'000'000, 1, 1}), Continuity::stepped_back);
  EXPECT_EQ(watch.check({10'000'000, 1, 2}), Continuity::repeated);
  EXPECT_EQ(watch.check({10'000'001, 1, 3}), Continuity::continues);
  EXPECT_EQ(watch.restarts(), 0);
}

TEST(ContinuityWatch, BeginsAnewAfterALargeStepBackOrInANewSession) {
  ContinuityWatch watch;
  watch.check({10'000'000, 1, 0});
  EXPECT_EQ(watch.check({7'999'999, 1, 1}), Continuity::began_anew);
  EXPECT_EQ(watch.check({8'000'000, 2, 0}), Continuity::began_anew);
  EXPECT_EQ(watch.restarts(), 2);
}

TEST(ContinuityWatch, CountsWhatNeverCame) {
  ContinuityWatch watch;
  watch.check({1, 1, 4});
  watch.check({2, 1, 5});
  watch.check({3, 1, 9});
  watch.check({4, 2, 100});
  EXPECT_EQ(watch.missed(), 3);
}

}  // namespace
}  // namespace perceptor
