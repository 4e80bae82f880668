#include <sstream>
#include <string>

#include <gmock/gmock.h>

#include "tests/support/recorded_data.hpp"
#include "tools/convert/conversion.hpp"
#include "tools/logcheck/log_check.hpp"
#include "tools/temporary_folder.hpp"

namespace perceptor {
namespace {

/// What `grep -c` finds in the file.
struct Recording {
  const char* file;
  std::int64_t scans;
  std::int64_t odometry;
};

void PrintTo(const Recording& recording, std::ostream* out) { *out << recording.file; }

class RecordedData : public ::testing::TestWithParam<Recording> {};

TEST_P(RecordedData, ConvertsWithoutLossToACompleteLog) {
  const Recording& expected = GetParam();
  PERCEPTOR_REQUIRE_RECORDED(expected.file);
  const TemporaryFolder folder;
  std::istringstream in(testing::unpacked(*testing::recorded(expected.file)));
  ConversionOptions options;
  options.events.still = expected.odometry == 0;
  const ConversionSummary summary = convert(in, expected.file, folder / "out.lcmlog", options);
  EXPECT_EQ(summary.scans, expected.scans);
  // A standing robot: one for each scan, one before and one after.
  EXPECT_EQ(summary.odometry, expected.odometry == 0 ? expected.scans + 2 : expected.odometry);
  EXPECT_TRUE(summary.dropped.empty());

  const LogReport report = check_log(folder / "out.lcmlog");
  EXPECT_EQ(report.verdict(), Verdict::complete);
  EXPECT_EQ(report.events, summary.scans + summary.odometry + 1);
  EXPECT_EQ(report.step_backs, 0);
}

INSTANTIATE_TEST_SUITE_P(All, RecordedData,
                         ::testing::Values(Recording{"logs/csail.log.xz", 1051, 1988},
                                           Recording{"logs/gh25_keyscans.log.xz", 163, 0},
                                           Recording{"logs/intel.log.xz", 2672, 0},
                                           Recording{"logs/intel_raw.log.xz", 2726, 2726},
                                           Recording{"logs/lcm_mbot_convex.log.xz", 459, 3422},
                                           Recording{"logs/mines_exp1.log.xz", 756, 756},
                                           Recording{"logs/pico_static.log.xz", 243, 0},
                                           Recording{"logs/uob_p3dx_trace0.log.xz", 958, 958},
                                           Recording{"logs/wean1.log.xz", 713, 2218},
                                           Recording{"logs/wean4.log.xz", 600, 1423},
                                           Recording{"originals/csail.carmen.log.xz", 686, 686}));

}  // namespace
}  // namespace perceptor
