#include "tools/eval/scan_evaluation.hpp"

#include <gmock/gmock.h>

#include "tests/support/scene.hpp"
#include "tools/eval/extract.hpp"
#include "tools/eval/floor.hpp"

namespace perceptor {
namespace {

using ::testing::Each;
using ::testing::Gt;
using ::testing::SizeIs;

/// A laser in a room with a pillar in one of its corners. It does not see what is behind it.
LaserScan room_scan() {
  return test::sweep(
      test::room({{-3.0, -2.0}, {4.0, -2.0}, {4.0, 2.0}, {3.0, 2.0}, {3.0, 3.0}, {-3.0, 3.0}}),
      test::pico_laser());
}

TEST(WallFinder, FindsWallsAndTheCornersWhereTwoMeet) {
  WallFinder finder({});
  finder.run(room_scan());
  const FoundWalls found = finder.found();
  EXPECT_THAT(found.walls, SizeIs(5));

  const auto kind_at = [&](const Vector2& corner) -> std::string {
    for (const auto& [location, is_convex] : found.corners)
      if (distance(location, corner) < 0.01) return is_convex ? "convex" : "concave";
    return "none";
  };
  EXPECT_EQ(kind_at({4.0, -2.0}), "concave");
  EXPECT_EQ(kind_at({4.0, 2.0}), "concave");
  EXPECT_EQ(kind_at({3.0, 2.0}), "convex");
  EXPECT_EQ(kind_at({3.0, 3.0}), "concave");
}

TEST(WallFinder, ForgetsTheLastScan) {
  WallFinder finder({});
  finder.run(room_scan());
  finder.run(LaserScan());
  EXPECT_TRUE(finder.found().walls.empty());
  EXPECT_TRUE(finder.found().corners.empty());
}

TEST(WallFinder, DoesNotTakeTheRobotForAWall) {
  WallFinder finder({}, {{3.5, -2.5}, {4.5, -2.5}, {4.5, 2.5}, {3.5, 2.5}});
  finder.run(room_scan());
  EXPECT_THAT(finder.found().walls, SizeIs(4));
}

TEST(Floor, SumsAreOfTheBeamsBefore) {
  LaserScan scan;
  scan.bearings = {0.0, 1.5707963267948966};
  scan.ranges = {2.0, 3.0};
  Floor floor(scan.bearings);
  floor.run(scan);
  ASSERT_THAT(floor.sums(), SizeIs(3));
  EXPECT_EQ(floor.sums()[0].w, 0.0);
  EXPECT_EQ(floor.sums()[1].w, 4.0);
  EXPECT_EQ(floor.sums()[1].wx, 8.0);
  EXPECT_EQ(floor.sums()[1].wxx, 16.0);
  EXPECT_EQ(floor.sums()[2].w, 13.0);
  EXPECT_NEAR(floor.sums()[2].wy, 27.0, 1e-12);
  EXPECT_NEAR(floor.sums()[2].wyy, 81.0, 1e-12);
  EXPECT_NEAR(floor.sums()[2].wxy, 0.0, 1e-12);
}

TEST(ScanEvaluation, RunsEachMethodOnEachScan) {
  ScanSet set;
  set.scans.resize(3);
  for (LabelledScan& scan : set.scans) scan.scan = room_scan();
  std::int64_t done = 0;
  const scan::ScanParameters parameters;
  const ScanEvaluation evaluation =
      evaluate(set, parameters, {{"one", parameters.method}, {"two", parameters.method}}, 2,
               [&](std::int64_t runs) { done = runs; });
  EXPECT_EQ(done, 9);
  EXPECT_THAT(evaluation.floor_us, SizeIs(3));
  EXPECT_FALSE(evaluation.bound);
  ASSERT_THAT(evaluation.methods, SizeIs(2));
  for (const MethodResult& method : evaluation.methods) {
    EXPECT_THAT(method.times_us, SizeIs(3));
    EXPECT_THAT(method.times_us, Each(Gt(0.0)));
    EXPECT_THAT(method.found, SizeIs(3));
    EXPECT_FALSE(method.score);
  }
  EXPECT_EQ(evaluation.methods[1].name, "two");
}

TEST(ScanEvaluation, LeavesOutWhatTheRobotCovers) {
  ScanSet set;
  set.footprint = {{-9.0, -9.0}, {9.0, -9.0}, {9.0, 9.0}, {-9.0, 9.0}};
  set.scans.resize(1);
  set.scans[0].scan = room_scan();
  const ScanEvaluation evaluation =
      evaluate(set, {}, {{"it", scan::ScanParameters().method}}, 1, [](std::int64_t) {});
  EXPECT_TRUE(evaluation.methods[0].found[0].walls.empty());
}

TEST(ScanEvaluation, ScoresWhereThereIsTruth) {
  ScanSet set;
  set.has_truth = true;
  set.scans.resize(1);
  set.scans[0].scan = room_scan();
  set.scans[0].pieces = {{1, 300, 400, 101, true, {{4.0, -2.0}, {4.0, 2.0}}}};
  const ScanEvaluation evaluation =
      evaluate(set, {}, {{"it", scan::ScanParameters().method}}, 1, [](std::int64_t) {});
  ASSERT_TRUE(evaluation.bound);
  EXPECT_EQ(evaluation.bound->pieces, 1);
  ASSERT_TRUE(evaluation.methods[0].score);
  EXPECT_EQ(evaluation.methods[0].score->pieces_found, 1);
  EXPECT_EQ(evaluation.methods[0].score->walls, 5);
}

}  // namespace
}  // namespace perceptor
