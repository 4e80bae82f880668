/// The local map over recorded drives: sharp, without double walls, and truer than odometry.
#include <fstream>

#include <gtest/gtest.h>

#include "tests/process/harness.hpp"
#include "tests/support/recorded_data.hpp"
#include "tools/eval/log_explanation.hpp"
#include "tools/eval/log_tracks.hpp"
#include "tools/eval/pose_reference.hpp"
#include "tools/eval/trajectory_score.hpp"

namespace perceptor::test {
namespace {

/// Errors of merge over those of odometry.
struct DriftBounds {
  double translation;
  double heading;
};

struct Drive {
  const char* name;
  std::vector<std::string> convert{};  ///< options of pico-convert
  double explained_by_current = 0.0;   ///< the least share of beams
  std::optional<DriftBounds> drift{};  ///< where the true poses are known
};

void PrintTo(const Drive& drive, std::ostream* out) { *out << drive.name; }

std::string log_of(const Drive& drive) { return "logs/" + std::string(drive.name) + ".log.xz"; }

class RecordedDrive : public ::testing::TestWithParam<Drive> {};

TEST_P(RecordedDrive, LocalMapExplainsTheScansOnce) {
  const Drive& drive = GetParam();
  PERCEPTOR_REQUIRE_RECORDED(log_of(drive));

  const ScratchFolder scratch;
  std::ofstream(scratch / "drive.log") << testing::unpacked(*testing::recorded(log_of(drive)));
  std::vector<std::string> convert{program("pico-convert"), scratch / "drive.log",
                                   scratch / "in.lcmlog"};
  convert.insert(convert.end(), drive.convert.begin(), drive.convert.end());
  // The odometry of some comes as seldom as every two seconds.
  const std::vector<std::string> replay{program("pico-replay"), scratch / "in.lcmlog",
                                        scratch / "out.lcmlog", "--set", "scan.aligner.max_gap=3"};
  for (const auto& command : {convert, replay}) {
    const Finished finished = run(command, Seconds(300));
    ASSERT_EQ(finished.exit_code, 0) << finished.output;
  }

  LogExplainer explainer;
  TrackReader tracks;
  LogReader reader(scratch / "out.lcmlog");
  while (const auto event = reader.next()) {
    explainer.take(*event);
    tracks.take(*event);
  }
  const LogExplanation& explanation = explainer.result();
  ASSERT_GT(explanation.compared, 0);
  const double current = value(explanation.by_current);
  EXPECT_GE(current, drive.explained_by_current);
  EXPECT_GE(value(explanation.by_local), 0.9 * current);

  // A pair in one map of twenty: things that stand closely before a wall and were seen beside it.
  const double doubles = value({explanation.doubles, explanation.compared});
  EXPECT_LE(doubles, 0.05);

  if (!drive.drift) return;
  std::ofstream(scratch / "true.ref")
      << testing::unpacked(*testing::recorded("logs/" + std::string(drive.name) + ".ref.xz"));
  const Trajectory reference = read_poses(scratch / "true.ref");
  const std::vector<Track> all = tracks.tracks();
  const Track& track = longest(all);
  const DriftScore merge = score_drift(track.merge, reference);
  const DriftScore odometry = score_drift(track.odometry, reference);
  ASSERT_GT(merge.pairs, 0);
  EXPECT_LE(merge.translation, drive.drift->translation * odometry.translation);
  EXPECT_LE(merge.heading, drive.drift->heading * odometry.heading);
}

INSTANTIATE_TEST_SUITE_P(All, RecordedDrive,
                         ::testing::Values(Drive{"csail", {}, 0.72, DriftBounds{0.5, 0.2}},
                                           Drive{"intel_raw", {}, 0.76, DriftBounds{0.5, 0.5}},
                                           Drive{"wean1"}, Drive{"uob_p3dx_trace0"},
                                           Drive{"lcm_mbot_convex",
                                                 {"--time-increment", "0.0005"}}),
                         [](const auto& name) { return std::string(name.param.name); });

}  // namespace
}  // namespace perceptor::test
