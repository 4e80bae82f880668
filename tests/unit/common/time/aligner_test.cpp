#include "common/time/aligner.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace perceptor {
namespace {

constexpr std::int64_t kMs = 1000;

/// An event on one of the two channels; items carry their own number.
struct Event {
  bool is_position;
  Stamp stamp;
  bool began_anew;
  std::int64_t zero_utime = 0;
  Position robot_in_zero = {};
};

Event position(std::int64_t utime, double x, bool began_anew = false, std::int64_t session = 1,
               std::int64_t zero_utime = 7) {
  return {true, {utime, session, 0}, began_anew, zero_utime, {x, 0.0, 0.0}};
}
Event item(std::int64_t utime, bool began_anew = false, std::int64_t session = 1) {
  return {false, {utime, session, 0}, began_anew};
}

using TestAligner = Aligner<int>;

std::string describe(const TestAligner::Outcome& outcome) {
  if (const auto* dropped = std::get_if<TestAligner::Dropped>(&outcome))
    return std::to_string(dropped->stamp.utime) + " " + std::string(dropped->reason);
  const auto& paired = std::get<TestAligner::Paired>(outcome);
  return std::to_string(paired.stamp.utime) +
         " x=" + std::to_string(paired.position.robot_in_zero.x) +
         " vx=" + std::to_string(paired.position.twist.vx) +
         (paired.position.began_anew ? " anew" : "");
}

std::vector<std::string> outcomes(const std::vector<Event>& events,
                                  const AlignerParameters& parameters = {}) {
  TestAligner aligner(parameters);
  std::vector<std::string> result;
  for (const Event& event : events) {
    if (event.is_position)
      aligner.add_position(event.stamp, event.began_anew, event.zero_utime, event.robot_in_zero);
    else
      aligner.add_item(event.stamp, event.began_anew, 0);
    while (const auto outcome = aligner.next()) result.push_back(describe(*outcome));
  }
  return result;
}

TEST(Aligner, InterpolatesBetweenThePositionsOnBothSides) {
  EXPECT_EQ(outcomes({position(0, 0.0, true), item(25 * kMs, true), position(100 * kMs, 1.0)}),
            std::vector<std::string>{"25000 x=0.250000 vx=10.000000 anew"});
}

TEST(Aligner, WaitsForTheFarSide) {
  EXPECT_TRUE(outcomes({position(0, 0.0, true), item(25 * kMs, true)}).empty());
}

TEST(Aligner, TakesAPositionWithinAMillisecondAlone) {
  EXPECT_EQ(outcomes({position(0, 0.0, true), item(1 * kMs, true)}),
            std::vector<std::string>{"1000 x=0.000000 vx=0.000000 anew"});
  EXPECT_TRUE(outcomes({position(0, 0.0, true), item(1 * kMs + 1, true)}).empty());
}

TEST(Aligner, DropsWhatLiesBeforeTheFirstPosition) {
  EXPECT_EQ(outcomes({item(5 * kMs, true), position(100 * kMs, 0.0, true)}),
            std::vector<std::string>{"5000 before the first position"});
}

TEST(Aligner, DropsWhereTheBracketIsTooWide) {
  EXPECT_EQ(outcomes({position(0, 0.0, true), item(100 * kMs, true), position(501 * kMs, 1.0)}),
            std::vector<std::string>{"100000 positions around it too far apart"});
  AlignerParameters wide;
  wide.max_gap = 3.0;
  EXPECT_EQ(
      outcomes({position(0, 0.0, true), item(100 * kMs, true), position(1000 * kMs, 1.0)}, wide),
      std::vector<std::string>{"100000 x=0.100000 vx=1.000000 anew"});
}

TEST(Aligner, TurnsTheShortWayRound) {
  TestAligner aligner{AlignerParameters{}};
  aligner.add_position({0, 1, 0}, true, 0, {0.0, 0.0, 3.1});
  aligner.add_item({50 * kMs, 1, 0}, true, 0);
  aligner.add_position({100 * kMs, 1, 1}, false, 0, {0.0, 0.0, -3.1});
  const auto outcome = aligner.next();
  ASSERT_TRUE(outcome);
  const auto& paired = std::get<TestAligner::Paired>(*outcome);
  EXPECT_NEAR(std::abs(paired.position.robot_in_zero.a), 3.14159265, 1e-6);
  EXPECT_NEAR(paired.position.twist.va, (2 * 3.14159265358979 - 6.2) / 0.1, 1e-9);
}

TEST(Aligner, NeverInterpolatesFromOneZeroFrameIntoAnother) {
  EXPECT_EQ(outcomes({position(0, 0.0, true), position(20 * kMs, 0.1), item(10 * kMs, true),
                      item(50 * kMs), position(100 * kMs, 0.0, false, 1, 99),
                      position(140 * kMs, 0.2, false, 1, 99), item(120 * kMs)}),
            (std::vector<std::string>{"10000 x=0.050000 vx=5.000000 anew",
                                      "50000 before the first position",
                                      "120000 x=0.100000 vx=5.000000 anew"}));
}

TEST(Aligner, GivesUpASessionWhosePositionsNeverCame) {
  EXPECT_EQ(outcomes({item(10 * kMs, true, 1), item(5 * kMs, true, 2), position(0, 0.0, true, 2),
                      position(10 * kMs, 1.0, false, 2)}),
            (std::vector<std::string>{"10000 no position in its session",
                                      "5000 x=0.500000 vx=100.000000 anew"}));
}

TEST(Aligner, DropsTheTailOfASessionThatEnded) {
  EXPECT_EQ(outcomes({position(0, 0.0, true, 1), position(10 * kMs, 1.0, false, 1),
                      item(50 * kMs, true, 1), position(0, 0.0, true, 2)}),
            std::vector<std::string>{"50000 after the last position"});
}

TEST(Aligner, OverflowDropsTheOldestAndSaysThatArrivalMattered) {
  AlignerParameters small;
  small.max_items = 2;
  TestAligner aligner(small);
  aligner.add_position({0, 1, 0}, true, 0, {});
  for (int i = 1; i <= 3; ++i) aligner.add_item({10 * i * kMs, 1, i}, i == 1, i);
  EXPECT_FALSE(TestAligner(small).depends_on_arrival());
  const auto outcome = aligner.next();
  ASSERT_TRUE(outcome);
  EXPECT_EQ(std::get<TestAligner::Dropped>(*outcome).reason, drop_reason::overflow);
  EXPECT_TRUE(aligner.depends_on_arrival());
  EXPECT_FALSE(aligner.next());
}

TEST(Aligner, AbandonsWhatStillWaitsOldestFirst) {
  TestAligner aligner{AlignerParameters{}};
  aligner.add_position({0, 1, 0}, true, 0, {});
  aligner.add_item({10 * kMs, 1, 0}, true, 0);
  aligner.add_item({20 * kMs, 1, 1}, false, 0);
  EXPECT_FALSE(aligner.next());
  for (const std::int64_t utime : {10 * kMs, 20 * kMs}) {
    const auto dropped = aligner.abandon();
    ASSERT_TRUE(dropped);
    EXPECT_EQ(dropped->stamp.utime, utime);
    EXPECT_EQ(dropped->reason, drop_reason::after_last);
  }
  EXPECT_FALSE(aligner.abandon());
}

TEST(Aligner, SaysWhenAnItemComesTooLateForWhatItRemembers) {
  AlignerParameters small;
  small.max_positions = 3;
  TestAligner aligner(small);
  for (int i = 0; i < 10; ++i) aligner.add_position({i * 10 * kMs, 1, i}, i == 0, 0, {});
  aligner.add_item({15 * kMs, 1, 0}, true, 0);
  const auto outcome = aligner.next();
  ASSERT_TRUE(outcome);
  EXPECT_EQ(std::get<TestAligner::Dropped>(*outcome).reason, drop_reason::forgotten);
  EXPECT_TRUE(aligner.depends_on_arrival());
}

TEST(Aligner, ExtrapolatesOnlyWhenAsked) {
  AlignerParameters ahead;
  ahead.max_extrapolation = 0.05;
  TestAligner aligner(ahead);
  aligner.add_position({0, 1, 0}, true, 0, {0.0, 0.0, 0.0});
  aligner.add_position({10 * kMs, 1, 1}, false, 0, {0.1, 0.0, 0.0});
  aligner.add_item({20 * kMs, 1, 0}, true, 0);
  const auto outcome = aligner.next();
  ASSERT_TRUE(outcome);
  EXPECT_NEAR(std::get<TestAligner::Paired>(*outcome).position.robot_in_zero.x, 0.2, 1e-12);
  EXPECT_TRUE(aligner.depends_on_arrival());
}

/// Two channels, each in its own order: sessions, restarts of the clock, gaps, another zero.
std::vector<Event> positions_of_a_long_day() {
  std::vector<Event> events;
  for (int i = 0; i < 100; ++i)
    if (i < 40 || i > 80) events.push_back(position(i * 20 * kMs, 0.01 * i, i == 0));
  for (int i = 0; i < 50; ++i) events.push_back(position((2000 + i * 20) * kMs, i, false, 1, 55));
  for (int i = 0; i < 50; ++i)  // the clock steps back within the session
    events.push_back(position((100 + i * 20) * kMs, -i, i == 0, 1, 66));
  for (int i = 0; i < 50; ++i) events.push_back(position(i * 20 * kMs, i, i == 0, 2, 77));
  return events;
}
std::vector<Event> items_of_a_long_day() {
  std::vector<Event> events;
  for (int i = 0; i < 120; ++i) events.push_back(item((7 + i * 25) * kMs, i == 0));
  for (int i = 0; i < 45; ++i) events.push_back(item((90 + i * 25) * kMs, i == 0));
  for (int i = 0; i < 35; ++i) events.push_back(item((3 + i * 25) * kMs, i == 0, 2));
  return events;
}

TEST(Aligner, OutcomesDoNotDependOnHowTheChannelsAreInterleaved) {
  const auto positions = positions_of_a_long_day();
  const auto items = items_of_a_long_day();
  AlignerParameters roomy;
  roomy.max_items = 1000;

  std::vector<Event> positions_first = positions;
  positions_first.insert(positions_first.end(), items.begin(), items.end());
  const auto expected = outcomes(positions_first, roomy);
  EXPECT_EQ(expected.size(), items.size());

  std::mt19937_64 random(4);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<Event> mixed;
    std::size_t p = 0;
    std::size_t i = 0;
    while (p < positions.size() || i < items.size()) {
      // A run of one channel, then a run of the other: late by up to a second either way.
      const auto run = static_cast<std::size_t>(random() % 40);
      for (std::size_t n = 0; n < run && p < positions.size(); ++n) mixed.push_back(positions[p++]);
      const auto other = static_cast<std::size_t>(random() % 40);
      for (std::size_t n = 0; n < other && i < items.size(); ++n) mixed.push_back(items[i++]);
    }
    EXPECT_EQ(outcomes(mixed, roomy), expected) << "trial " << trial;
  }
}

}  // namespace
}  // namespace perceptor
