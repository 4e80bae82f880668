#include "tools/eval/scan_explanation.hpp"

#include <limits>

#include <gmock/gmock.h>

#include "tests/unit/tools/eval/findings.hpp"

namespace perceptor {
namespace {

using scan::Fate;
using scan::Limit;
using scan::Verdict;
using ::testing::EndsWith;
using testing::HandMade;
using ::testing::HasSubstr;
using ::testing::StartsWith;

std::string about(const HandMade& made, std::size_t beam) {
  return explain_beam(made.findings(), beam, {});
}

/// All beams in a run that is no wall.
HandMade without_wall(Verdict verdict) {
  HandMade made;
  made.found.walls.clear();
  made.account.groups = {{0, 4, Fate::without_wall, 0}};
  made.account.runs[0].verdict = verdict;
  made.account.runs[0].wall = scan::kNoWall;
  return made;
}

TEST(ExplainBeam, PartOfAWall) {
  EXPECT_EQ(about(HandMade(), 2),
            "beam 2 at 0.000 rad, 2.004 m: part of wall 0, from (2.00, -0.50) to (2.00, 0.50), "
            "4 mm off its line.\n"
            "Its run 0, 4 beams (1 to 4), from a gap of 0.41 m to the scan's end: wall 0: beams "
            "3 of at least 6 (wall.min_beams), share 0.75 of at least 0.7 "
            "(wall.min_support_share), length 1.00 m of at least 0.25 m (wall.min_length), sigma "
            "of direction 0.0125 rad of at most 0.08 rad (wall.max_angle_sigma).\n"
            "What a gap is: gap.min_incidence 0.087 rad, gap.max_hole 0.3 m.\n");
}

TEST(ExplainBeam, OffTheLineOfItsWall) {
  EXPECT_THAT(about(HandMade(), 4),
              StartsWith("beam 4 at 0.500 rad, 2.400 m: in a run that is wall 0, from (2.00, "
                         "-0.50) to (2.00, 0.50), 106 mm off its line: too far to be part of it "
                         "(wall.support_sigmas 3.5).\nIts run 0, 4 beams"));
}

TEST(ExplainBeam, WithoutReturn) {
  HandMade made;
  EXPECT_EQ(about(made, 0), "beam 0 at -0.500 rad, 0.000 m: no return: 0.000 m is not positive.\n");
  made.labelled.scan.ranges[0] = 0.125;
  EXPECT_EQ(about(made, 0),
            "beam 0 at -0.500 rad, 0.125 m: no return: 0.125 m is not within [0.25, 60], what "
            "the scan says of its laser.\n");
  made.labelled.scan.ranges[0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(about(made, 0), EndsWith("no return: nan is no range.\n"));
}

TEST(ExplainBeam, InNoRun) {
  HandMade made;
  made.account.groups[0].fate = Fate::on_robot;
  EXPECT_THAT(about(made, 0), EndsWith("inside the robot's footprint (robot.footprint).\n"));
  made.account.groups[0].fate = Fate::stray;
  EXPECT_THAT(about(made, 0), HasSubstr("jumps away from both its neighbours"));
  EXPECT_THAT(about(made, 0), HasSubstr("gap.max_hole 0.3 m"));
  made.account.groups[0].fate = Fate::in_no_run;
  EXPECT_THAT(about(made, 0), HasSubstr("in no run: too few neighbours"));
  EXPECT_THAT(about(made, 0), HasSubstr("(wall.merge_chi2 12)"));
}

TEST(ExplainBeam, EachVerdictNamesItsValueAndItsLimit) {
  const auto verdict = [](Verdict reason) { return about(without_wall(reason), 1); };
  EXPECT_THAT(verdict(Verdict::too_few_beams),
              HasSubstr("in a run that is no wall.\nIts run 0, 4 beams (1 to 4), from a gap of "
                        "0.41 m to the scan's end: too few beams support a line: 3 of at least 6 "
                        "(wall.min_beams).\n"));
  EXPECT_THAT(verdict(Verdict::too_scattered),
              HasSubstr("0.75 of at least 0.7 (wall.min_support_share)"));
  EXPECT_THAT(verdict(Verdict::too_short),
              HasSubstr("1.00 m of at least 0.25 m (wall.min_length)"));
  EXPECT_THAT(verdict(Verdict::too_uncertain),
              HasSubstr("0.0125 rad of at most 0.08 rad (wall.max_angle_sigma)"));
}

TEST(ExplainBeam, LimitsAreThoseOfTheParameters) {
  scan::ScanParameters parameters;
  parameters.wall.min_beams = 9;
  EXPECT_THAT(explain_beam(without_wall(Verdict::too_few_beams).findings(), 1, parameters),
              HasSubstr("3 of at least 9"));
}

TEST(ExplainBeam, SaysWhatARunEndsAt) {
  HandMade made;
  made.account.runs[0].before = {Limit::strays, 0.2, 0.0};
  made.account.runs[0].after = {Limit::corner, 0.01, -1.5184};
  EXPECT_THAT(about(made, 1), HasSubstr("from beams in no run to a corner of 87 deg"));
  EXPECT_THAT(about(made, 1), EndsWith("What one line explains: wall.merge_chi2 12, wall.bend "
                                       "0.008 m, noise.surface_roughness 0.003 m.\n"));
}

TEST(ExplainScan, ListsBeamsAndRuns) {
  EXPECT_EQ(explain_scan(HandMade().findings(), {}),
            "scan 12 at 3.500 s: 5 beams, 4 returns, 1 run, 1 wall, 0 corners\n"
            "\n"
            "         beams    bearings [rad]  what became of them\n"
            "     0      0   -0.500   -0.500  no return\n"
            "     1      3   -0.250    0.250  run 0, part of wall 0\n"
            "     4      4    0.500    0.500  run 0, off the line of wall 0\n"
            "\n"
            "run 0, 4 beams (1 to 4), from a gap of 0.41 m to the scan's end: wall 0 of 3 beams, "
            "1.00 m\n");
}

TEST(ExplainScan, SaysWhyARunIsNoWall) {
  const std::string text = explain_scan(without_wall(Verdict::too_short).findings(), {});
  EXPECT_THAT(text, HasSubstr("0.500  run 0, no wall\n"));
  EXPECT_THAT(text, HasSubstr("too short: 1.00 m of at least 0.25 m (wall.min_length)\n"));
}

TEST(NearestBeam, GoesTheShortWayRound) {
  LaserScan scan;
  scan.bearings = {-3.0, -1.0, 1.0, 3.0};
  EXPECT_EQ(nearest_beam(scan, 0.9), 2U);
  EXPECT_EQ(nearest_beam(scan, 3.1), 3U);
  EXPECT_EQ(nearest_beam(scan, 3.2), 0U);
  EXPECT_EQ(nearest_beam(scan, -3.2), 3U);
}

}  // namespace
}  // namespace perceptor
