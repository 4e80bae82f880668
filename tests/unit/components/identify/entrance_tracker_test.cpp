#include "components/identify/entrance_tracker.hpp"

#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "common/geometry/angle.hpp"
#include "tests/unit/components/identify/scene.hpp"

namespace perceptor::identify::test {
namespace {

constexpr double kExact = 1e-9;
constexpr double kUp = 0.5 * std::numbers::pi;
constexpr int kNeeded = 9;  // 60 % of 15 scans
constexpr int kScans = 15;

Map closed_room() {
  Map map;
  draw_ring(map, {{3, 2}, {-3, 2}, {-3, -2}, {3, -2}});
  return map;
}

const Exit kAhead{.middle = {2, 0}, .direction = 0.0, .width = 0.9, .confidence = 1.0};

/// A robot that looks at rooms, forty times a second unless told otherwise.
class EntranceTrackerTest : public testing::Test {
 protected:
  std::optional<Exit> see(const std::vector<Exit>& exits, const Position& robot_in_local = {}) {
    utime_ += period_us_;
    return tracker_.update(utime_, robot_in_local, exits);
  }
  std::optional<Exit> look_at(const Map& in_local, const Position& robot_in_local = {}) {
    Map map = perceptor::transform(in_local, inverse(robot_in_local));
    identify(map, kRobot);
    return see(find_exits(map, read_walls(map), kRobot, utime_), robot_in_local);
  }
  /// The last answer of many alike.
  std::optional<Exit> see_often(const std::vector<Exit>& exits, int times,
                                const Position& robot_in_local = {}) {
    std::optional<Exit> entrance;
    for (int i = 0; i < times; ++i) entrance = see(exits, robot_in_local);
    return entrance;
  }

  EntranceTracker tracker_;
  std::int64_t utime_ = 0;
  std::int64_t period_us_ = 25'000;
};

TEST_F(EntranceTrackerTest, DoorwayIsTheEntranceOnceEnoughScansSawIt) {
  for (int i = 1; i < kNeeded; ++i) EXPECT_FALSE(look_at(room_with_doorway())) << i;
  const auto entrance = look_at(room_with_doorway());
  ASSERT_TRUE(entrance);
  EXPECT_NEAR(distance(entrance->middle, {0, 2}), 0.0, kExact);
  EXPECT_NEAR(entrance->direction, kUp, kExact);
  EXPECT_NEAR(entrance->width, 0.9, kExact);
  EXPECT_NEAR(entrance->confidence, 1.0, kExact);
}

TEST_F(EntranceTrackerTest, GhostDoorOfOneScanNeverIsTheEntrance) {
  EXPECT_FALSE(look_at(room_with_doorway()));
  for (int i = 0; i < 2 * kScans; ++i) EXPECT_FALSE(look_at(closed_room()));
}

TEST_F(EntranceTrackerTest, DoorInEverySecondScanNeverIsTheEntrance) {
  for (int i = 0; i < 2 * kScans; ++i) {
    EXPECT_FALSE(look_at(room_with_doorway()));
    EXPECT_FALSE(look_at(closed_room()));
  }
}

TEST_F(EntranceTrackerTest, DoorThatIsGoneIsForgotten) {
  ASSERT_TRUE(see_often({kAhead}, kScans));
  EXPECT_TRUE(see_often({}, kScans - kNeeded));
  EXPECT_FALSE(see({}));
}

TEST_F(EntranceTrackerTest, StaysInPlaceWhileTheRobotDrivesAndTurns) {
  for (int i = 0; i < 100; ++i) {  // as fast as PICO can
    const double t = 0.025 * i;
    const Position robot_in_local{-2.0 + 0.5 * t, -1.0 + 0.2 * t, wrap_angle(1.2 * t)};
    const auto entrance = look_at(room_with_doorway(), robot_in_local);
    if (i + 1 < kNeeded) continue;
    ASSERT_TRUE(entrance) << i;
    const Exit in_local = transform(robot_in_local, *entrance);
    EXPECT_NEAR(distance(in_local.middle, {0, 2}), 0.0, kExact);
    EXPECT_NEAR(in_local.direction, kUp, kExact);
  }
}

TEST_F(EntranceTrackerTest, MedianIsWithinACentimetreOfANoisyDoor) {
  // The median of 15 has a third of the noise of one: 3.2 mm, so 1 cm is three sigmas.
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0.0, 0.01);
  for (int i = 0; i < 100; ++i) {
    Exit exit = kAhead;
    exit.middle += Vector2(noise(random), noise(random));
    exit.width += noise(random);
    exit.direction += noise(random);
    const auto entrance = see({exit});
    if (i + 1 < kScans) continue;
    ASSERT_TRUE(entrance) << i;
    EXPECT_NEAR(entrance->middle.x(), 2.0, 0.01);
    EXPECT_NEAR(entrance->middle.y(), 0.0, 0.01);
    EXPECT_NEAR(entrance->width, 0.9, 0.01);
    EXPECT_NEAR(entrance->direction, 0.0, 0.01);
  }
}

TEST_F(EntranceTrackerTest, FewWildSightingsDoNotMoveTheMedian) {
  Exit wild = kAhead;
  wild.middle.y() += 0.3;
  wild.width = 1.4;
  for (int i = 0; i < 2 * kScans; ++i) {
    const auto entrance = see({i % 4 == 3 ? wild : kAhead});
    if (i + 1 < kScans) continue;
    ASSERT_TRUE(entrance);
    EXPECT_NEAR(distance(entrance->middle, kAhead.middle), 0.0, kExact);
    EXPECT_NEAR(entrance->width, 0.9, kExact);
  }
}

TEST_F(EntranceTrackerTest, OpeningThatIsElsewhereEachTimeIsNoEntrance) {
  for (int i = 0; i < 2 * kScans; ++i) {
    Exit exit = kAhead;
    exit.middle.y() = 0.15 * (i % 3 - 1);
    EXPECT_FALSE(see({exit}));
  }
}

TEST_F(EntranceTrackerTest, DirectionsOnBothSidesOfPiHaveTheirMedianThere) {
  const Exit behind{
      .middle = {-2, 0}, .direction = std::numbers::pi, .width = 0.9, .confidence = 1.0};
  for (int i = 0; i < kScans; ++i) {
    Exit exit = behind;
    exit.direction = wrap_angle(std::numbers::pi + 0.05 * (i % 3 - 1));
    const auto entrance = see({exit});
    if (i + 1 < kScans) continue;
    ASSERT_TRUE(entrance);
    EXPECT_NEAR(std::abs(entrance->direction), std::numbers::pi, kExact);
  }
}

TEST_F(EntranceTrackerTest, NearOneOfTwoAlikeIsTheBest) {
  const Exit left{.middle = {0, 3}, .direction = kUp, .width = 0.9, .confidence = 1.0};
  const auto entrance = see_often({left, kAhead}, kScans);
  ASSERT_TRUE(entrance);
  EXPECT_NEAR(distance(entrance->middle, kAhead.middle), 0.0, kExact);
}

TEST_F(EntranceTrackerTest, CertainOneIsBetterThanANearDoubtfulOne) {
  const Exit left{.middle = {0, 3}, .direction = kUp, .width = 0.9, .confidence = 1.0};
  Exit doubtful = kAhead;
  doubtful.confidence = 0.55;
  const auto entrance = see_often({doubtful, left}, kScans);
  ASSERT_TRUE(entrance);
  EXPECT_NEAR(distance(entrance->middle, left.middle), 0.0, kExact);
  doubtful.confidence = 0.4;
  tracker_.clear();
  EXPECT_FALSE(see_often({doubtful}, kScans)) << "alone it is not certain enough";
}

TEST_F(EntranceTrackerTest, TheOneThatWasNamedStaysUntilAnotherIsClearlyBetter) {
  const Exit left{.middle = {0, 2.2}, .direction = kUp, .width = 0.9, .confidence = 1.0};
  const auto seen_from = [&](double y) {
    const Position robot_in_local{0, y, 0};
    const Position local_in_robot = inverse(robot_in_local);
    const auto entrance = see_often(
        {transform(local_in_robot, kAhead), transform(local_in_robot, left)}, 1, robot_in_local);
    return entrance ? transform(robot_in_local, *entrance).middle : Vector2::Zero();
  };
  for (int i = 0; i < kScans; ++i) seen_from(0.0);
  EXPECT_NEAR(distance(seen_from(0.0), kAhead.middle), 0.0, kExact);
  EXPECT_NEAR(distance(seen_from(0.5), kAhead.middle), 0.0, kExact) << "left is a little nearer";
  EXPECT_NEAR(distance(seen_from(1.2), left.middle), 0.0, kExact) << "and now much";
}

TEST_F(EntranceTrackerTest, NoneIsNamedOnceTheRobotIsThrough) {
  ASSERT_TRUE(see_often({kAhead}, kScans));
  EXPECT_TRUE(see({}, {1.9, 0, 0}));
  EXPECT_FALSE(see({}, {2.1, 0, 0}));
}

TEST_F(EntranceTrackerTest, BeginsAnewWhenCleared) {
  ASSERT_TRUE(see_often({kAhead}, kScans));
  tracker_.clear();
  EXPECT_FALSE(see_often({kAhead}, kNeeded - 1));
  EXPECT_TRUE(see({kAhead}));
}

TEST_F(EntranceTrackerTest, OldScansDoNotCount) {
  period_us_ = 150'000;  // eleven scans in 1.5 s
  EXPECT_TRUE(see_often({kAhead}, kScans));
  tracker_.clear();
  period_us_ = 200'000;  // eight
  EXPECT_FALSE(see_often({kAhead}, 2 * kScans));
}

TEST_F(EntranceTrackerTest, NothingFarAwayIsNamed) {
  ASSERT_TRUE(see_often({kAhead}, kScans));
  EXPECT_FALSE(see({}, {-1e6, 0, 0})) << "a pose that leapt";
}

}  // namespace
}  // namespace perceptor::identify::test
