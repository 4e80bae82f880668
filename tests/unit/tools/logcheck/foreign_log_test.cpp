#include <fstream>
#include <sstream>
#include <string>

#include <gmock/gmock.h>

#include "tests/support/recorded_data.hpp"
#include "tools/logcheck/log_check.hpp"
#include "tools/temporary_folder.hpp"

namespace perceptor {
namespace {

using ::testing::HasSubstr;

constexpr const char* kForeign = "originals/mbot_convex.lcmlog.xz";

/// Recorded by lcm-logger, from another project's robot.
class ForeignLog : public ::testing::Test {
 protected:
  void SetUp() override {
    PERCEPTOR_REQUIRE_RECORDED(kForeign);
    bytes_ = testing::unpacked(*testing::recorded(kForeign));
  }

  LogReport check(const std::string& bytes) const {
    std::ofstream(folder_ / "a.lcmlog") << bytes;
    return check_log(folder_ / "a.lcmlog");
  }

  TemporaryFolder folder_;
  std::string bytes_;
};

TEST_F(ForeignLog, IsReadAndSaidToHoldNoChannelOfOurs) {
  const LogReport report = check(bytes_);
  EXPECT_EQ(report.events, 5714);
  EXPECT_TRUE(report.damage.empty());
  EXPECT_EQ(exit_code(report), 3);
  ASSERT_EQ(report.channels.size(), 4U);
  EXPECT_EQ(report.channels[0].channel, "MAEBOT_ENCODERS");
  EXPECT_EQ(report.channels[0].count, 3422);
  for (const ChannelReport& channel : report.channels)
    EXPECT_THAT(channel.reasons[0], HasSubstr("no channel of ours"));
}

TEST_F(ForeignLog, LosesLittleToDamage) {
  std::string damaged = bytes_;
  constexpr std::size_t begin = 1'000'000;
  constexpr std::size_t garbage = 10'000;
  for (std::size_t i = 0; i < garbage; ++i) damaged[begin + i] = static_cast<char>(i * 37);
  damaged.resize(damaged.size() - 7);
  const LogReport report = check(damaged);
  ASSERT_EQ(report.damage.size(), 2U);
  // The garbage, and the events that it cut into: none is larger than 5 kB here.
  EXPECT_LT(report.damage[0].size, static_cast<std::int64_t>(garbage + 2 * 5000));
  EXPECT_EQ(report.damage[1].offset + report.damage[1].size, report.size);
  EXPECT_GT(report.events, 5600);
}

TEST_F(ForeignLog, UnderOurChannelsNamesItIsUndecodableNotFatal) {
  std::string renamed = bytes_;
  const std::string theirs = "RPLIDAR_LASER";
  const std::string ours = "STATUS_BRIDGE";
  for (std::size_t at = renamed.find(theirs); at != std::string::npos;
       at = renamed.find(theirs, at))
    renamed.replace(at, theirs.size(), ours);
  const LogReport report = check(renamed);
  EXPECT_EQ(report.events, 5714);
  EXPECT_EQ(exit_code(report), 1);
}

}  // namespace
}  // namespace perceptor
