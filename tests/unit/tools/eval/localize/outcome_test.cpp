#include "tools/eval/localize/outcome.hpp"

#include <gtest/gtest.h>

namespace perceptor {
namespace {

/// Ten fixes a second, tracking `off` metres from the truth.
void add_fixes(std::vector<Fix>& fixes, double seconds, bool is_tracking, double off) {
  const auto count = static_cast<int>(seconds * 10.0);
  for (int i = 0; i < count; ++i) {
    Fix fix;
    fix.time = static_cast<double>(fixes.size()) / 10.0;
    fix.robot_in_world.pose.x = off;
    fix.robot_in_world.covariance = 1e-4 * Eigen::Matrix3d::Identity();
    fix.is_tracking = is_tracking;
    fixes.push_back(fix);
  }
}

TEST(Outcome, FoundCountsWhereItIsHeld) {
  Drive drive;
  add_fixes(drive.fixes, 2.0, false, 0.0);
  add_fixes(drive.fixes, 5.0, true, 0.01);
  add_fixes(drive.fixes, 1.0, false, 0.01);
  add_fixes(drive.fixes, 12.0, true, 0.01);
  const Outcome outcome = judge(drive);
  ASSERT_TRUE(outcome.found);
  EXPECT_NEAR(*outcome.found, 8.0, 0.11);
  EXPECT_EQ(outcome.longest_false, 0.0);
  EXPECT_NEAR(outcome.error.squared_distance / outcome.error.fixes, 1e-4, 1e-9);
  EXPECT_NEAR(outcome.error.nees / outcome.error.fixes, 1.0, 1e-9);
}

TEST(Outcome, TrackingElsewhereIsFalse) {
  Drive drive;
  add_fixes(drive.fixes, 3.0, true, 0.5);
  add_fixes(drive.fixes, 3.0, false, 0.5);
  add_fixes(drive.fixes, 1.0, true, 0.5);
  const Outcome outcome = judge(drive);
  EXPECT_FALSE(outcome.found);
  EXPECT_NEAR(outcome.longest_false, 2.9, 0.11);
}

TEST(Outcome, KidnappingIsNoticedAndTheRobotFoundAgain) {
  Drive drive;
  add_fixes(drive.fixes, 12.0, true, 0.0);
  add_fixes(drive.after, 1.5, true, 3.0);
  add_fixes(drive.after, 2.0, false, 0.0);
  add_fixes(drive.after, 12.0, true, 0.02);
  const Outcome outcome = judge(drive);
  EXPECT_TRUE(outcome.was_tracking);
  EXPECT_NEAR(outcome.noticed.value_or(-1.0), 1.5, 0.11);
  EXPECT_NEAR(outcome.found_again.value_or(-1.0), 3.5, 0.11);
}

TEST(Outcome, WhoWasLostCannotBeKidnapped) {
  Drive drive;
  add_fixes(drive.fixes, 12.0, false, 0.0);
  add_fixes(drive.after, 12.0, true, 0.0);
  EXPECT_FALSE(judge(drive).was_tracking);
}

}  // namespace
}  // namespace perceptor
