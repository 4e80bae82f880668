// Why a beam is part of a wall, or of none.

#include "components/scan/explain.hpp"

#include <gtest/gtest.h>

#include "tests/unit/components/scan/scan_scene.hpp"

namespace perceptor::test {
namespace {

using namespace perceptor::scan;

/// Of the group that a beam is in.
BeamGroup group_of(const Account& account, std::size_t beam) {
  return *std::ranges::find_if(account.groups, [beam](const BeamGroup& group) {
    return group.first_beam <= beam && beam <= group.last_beam;
  });
}

/// Beams from -0.5 to 0.5 rad, 2 mrad apart; beam 250 looks straight ahead.
SceneLaser narrow_laser(double sigma = 0.002) {
  SceneLaser laser;
  laser.bearings = fan(501, -0.5, 0.5);
  laser.sigma = sigma;
  return laser;
}

Account account_of(const LaserScan& scan, const ScanParameters& parameters = {}) {
  WallExtractor extractor(parameters);
  extractor.extract(scan);
  return explain(extractor, scan);
}

TEST(Explain, EveryBeamHasOneFate) {
  LaserScan scan = sweep({{{2, -2}, {2, 2}}}, narrow_laser());
  scan.ranges[3] = 0.0;
  const Account account = account_of(scan);
  std::size_t next = 0;
  for (const BeamGroup& group : account.groups) {
    EXPECT_EQ(group.first_beam, next);
    next = group.last_beam + 1;
  }
  EXPECT_EQ(next, scan.size());
}

TEST(Explain, BeamsOfAWallSupportItFromTheScansEndToItsEnd) {
  const Account account = account_of(sweep({{{2, -2}, {2, 2}}}, narrow_laser()));
  ASSERT_EQ(account.runs.size(), 1U);
  const RunAccount& run = account.runs[0];
  EXPECT_EQ(run.verdict, Verdict::wall);
  EXPECT_EQ(run.wall, 0U);
  EXPECT_GT(run.support, 495);
  EXPECT_NEAR(run.length, 2.0 * 2.0 * std::tan(0.5), 0.02);
  EXPECT_EQ(run.before.limit, Limit::scan_end);
  EXPECT_EQ(run.after.limit, Limit::scan_end);
  EXPECT_EQ(group_of(account, 250).fate, Fate::supports);
}

TEST(Explain, SaysWhichBeamsDidNotReturnAndWhichJumpAway) {
  LaserScan scan = sweep({{{2, -2}, {2, 2}}}, narrow_laser());
  scan.ranges[100] = 0.0;
  scan.ranges[250] = 0.8;
  const Account account = account_of(scan);
  EXPECT_EQ(group_of(account, 100).fate, Fate::no_return);
  EXPECT_EQ(group_of(account, 250).fate, Fate::stray);
  EXPECT_EQ(group_of(account, 251).fate, Fate::supports);
}

TEST(Explain, SaysWhichBeamsEndOnTheRobot) {
  const std::vector<Vector2> footprint = {{0.4, -0.4}, {0.4, 0.4}, {-0.4, 0.4}, {-0.4, -0.4}};
  const LaserScan scan = sweep({{{0.3, -0.3}, {0.3, 0.3}}}, narrow_laser());
  WallExtractor extractor({}, footprint);
  extractor.extract(scan);
  EXPECT_EQ(group_of(explain(extractor, scan), 250).fate, Fate::on_robot);
}

TEST(Explain, PostInFrontOfAWallIsTooShortBetweenTwoGaps) {
  const Scene scene = {{{1.5, -0.1}, {1.5, 0.1}}, {{3, -3}, {3, 3}}};
  const Account account = account_of(sweep(scene, narrow_laser()));
  const BeamGroup post = group_of(account, 250);
  ASSERT_EQ(post.fate, Fate::without_wall);
  const RunAccount& run = account.runs[post.run];
  EXPECT_EQ(run.verdict, Verdict::too_short);
  EXPECT_NEAR(run.length, 0.2, 0.01);
  EXPECT_EQ(run.before.limit, Limit::gap);
  EXPECT_EQ(run.after.limit, Limit::gap);
  EXPECT_NEAR(run.before.step, 1.5, 0.05);
}

TEST(Explain, FewBeamsAreSaidToBeTooFew) {
  ScanParameters parameters;
  parameters.wall.min_beams = 400;
  const Scene scene = {{{1.5, -0.3}, {1.5, 0.3}}, {{3, -3}, {3, 3}}};
  const Account account = account_of(sweep(scene, narrow_laser()), parameters);
  const BeamGroup group = group_of(account, 250);
  ASSERT_EQ(group.fate, Fate::without_wall);
  EXPECT_EQ(account.runs[group.run].verdict, Verdict::too_few_beams);
  EXPECT_EQ(account.runs[group.run].support, static_cast<int>(account.runs[group.run].beams));
}

TEST(Explain, DirectionOfAShortNoisyWallIsTooUncertain) {
  ScanParameters parameters;
  parameters.wall.max_angle_sigma = 0.01;
  const Scene scene = {{{1.5, -0.2}, {1.5, 0.2}}, {{3, -3}, {3, 3}}};
  const Account account = account_of(sweep(scene, narrow_laser(0.02)), parameters);
  const BeamGroup group = group_of(account, 250);
  ASSERT_EQ(group.fate, Fate::without_wall);
  EXPECT_EQ(account.runs[group.run].verdict, Verdict::too_uncertain);
  EXPECT_GT(account.runs[group.run].angle_sigma, 0.01);
}

TEST(Explain, FirstRunOfAnOpenScanBeginsAfterBeamsInNone) {
  // Three scattered beams, and then a wall 2 m away: the step to it is known, not guessed.
  LaserScan scan = sweep({{{2, -2}, {2, 2}}}, narrow_laser());
  for (const std::size_t beam : {0U, 1U, 2U}) scan.ranges[beam] = 5.0 + static_cast<double>(beam);
  const Account account = account_of(scan);
  ASSERT_EQ(account.runs.size(), 1U);
  EXPECT_EQ(account.runs[0].first_beam, 3U);
  EXPECT_EQ(account.runs[0].before.limit, Limit::gap);
  EXPECT_NEAR(account.runs[0].before.step, 7.0 - scan.ranges[3], 0.01);
  EXPECT_EQ(account.runs[0].after.limit, Limit::scan_end);
}

TEST(Explain, WallsThatMeetEndAtACornerWithItsTurn) {
  // A room's corner: to the left, by a quarter turn.
  const Account account = account_of(sweep(chain({{2, -2}, {2, 0.3}, {0, 0.3}}), narrow_laser()));
  ASSERT_EQ(account.runs.size(), 2U);
  EXPECT_EQ(account.runs[0].after.limit, Limit::corner);
  EXPECT_EQ(account.runs[1].before.limit, Limit::corner);
  EXPECT_NEAR(account.runs[0].after.turn, std::numbers::pi / 2, 0.02);
  EXPECT_NEAR(account.runs[1].before.turn, std::numbers::pi / 2, 0.02);
}

TEST(Explain, InACircleTheLastRunMeetsTheFirst) {
  SceneLaser laser;
  laser.bearings = circle(1000);
  const Account account = account_of(sweep(room(room_corners()), laser));
  ASSERT_EQ(account.runs.size(), 4U);
  for (const RunAccount& run : account.runs) {
    EXPECT_EQ(run.before.limit, Limit::corner);
    EXPECT_EQ(run.after.limit, Limit::corner);
    EXPECT_NEAR(run.after.turn, std::numbers::pi / 2, 0.02);
  }
}

TEST(Explain, ScanWithoutBeamsHasNothingToTell) {
  const Account account = account_of({});
  EXPECT_TRUE(account.groups.empty());
  EXPECT_TRUE(account.runs.empty());
}

}  // namespace
}  // namespace perceptor::test
