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

TEST(ContinuityWatch, WhatComesLateOrIsTurnedDownIsNotMissed) {
  ContinuityWatch watch;
  watch.check({10, 1, 0});
  watch.check({40, 1, 3});
  EXPECT_EQ(watch.missed(), 2);
  EXPECT_EQ(watch.check({20, 1, 1}), Continuity::stepped_back);
  EXPECT_EQ(watch.missed(), 1);
  EXPECT_EQ(watch.check({20, 1, 1}), Continuity::stepped_back) << "twice";
  EXPECT_EQ(watch.missed(), 1);
  EXPECT_EQ(watch.check({39, 1, 4}), Continuity::stepped_back) << "a clock that stepped back";
  watch.check({50, 1, 5});
  EXPECT_EQ(watch.missed(), 1);
}

TEST(ContinuityWatch, WhatCameBeforeTheFirstIsNotMissed) {
  ContinuityWatch watch;
  watch.check({10, 1, 5});
  EXPECT_EQ(watch.check({8, 1, 3}), Continuity::stepped_back);
  EXPECT_EQ(watch.missed(), 0);
}

TEST(ContinuityWatch, ALeapOfNumbersIsMissedAndWhatIsOlderThanTheWindowStaysSo) {
  ContinuityWatch watch;
  watch.check({10, 1, 0});
  watch.check({20, 1, 1000});
  watch.check({15, 1, 900});
  EXPECT_EQ(watch.missed(), 999);
  watch.check({15, 1, 999});
  EXPECT_EQ(watch.missed(), 998);
}

TEST(ContinuityWatch, LeapsOfAnySizeDoNotOverflow) {
  ContinuityWatch watch;
  for (std::int64_t session = 0; session < 20; ++session) {
    watch.check({10, session, 0});
    watch.check({20, session, ContinuityWatch::kMostMissed});
  }
  EXPECT_EQ(watch.missed(), ContinuityWatch::kMostMissed);
}

TEST(ContinuityWatch, SeesThatTwoSourcesTakeTurns) {
  ContinuityWatch watch;
  std::int64_t time = 0;
  const auto send = [&](std::int64_t session, int messages) {
    for (int i = 0; i < messages; ++i) watch.check({++time, session, time});
  };
  send(1, 100);
  send(2, 1);
  EXPECT_FALSE(watch.is_contested()) << "a robot that was started anew";
  send(1, 1);
  EXPECT_TRUE(watch.is_contested());
  send(2, 2);
  EXPECT_TRUE(watch.is_contested());
  send(2, ContinuityWatch::kTurn);
  EXPECT_FALSE(watch.is_contested()) << "the other one is gone";
  send(1, 1);
  EXPECT_FALSE(watch.is_contested()) << "one after the other";
}

}  // namespace
}  // namespace perceptor
