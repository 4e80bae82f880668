#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "common/log/event_log.hpp"
#include "tests/unit/tools/logcheck/fake_publisher.hpp"
#include "tools/logcheck/log_check.hpp"
#include "tools/temporary_folder.hpp"

namespace perceptor {
namespace {

using ::testing::ElementsAre;

/// A whole run, in a file that the tests then damage.
class LogcheckFile : public ::testing::Test {
 protected:
  LogcheckFile() {
    Publisher bridge(log_, "bridge", 1);
    bridge.status();
    for (int i = 0; i < 20; ++i) bridge.scan(10, i);
    bridge.status(true);
    LogWriter writer(file());
    for (const LogEvent& e : log_)
      writer.write(e.channel, e.timestamp, e.data.data(), e.data.size());
    writer.close();
  }

  std::filesystem::path file() const { return folder_ / "a.lcmlog"; }

  std::string bytes() const {
    std::ifstream in(file());
    return {std::istreambuf_iterator<char>(in), {}};
  }

  void write(const std::string& bytes) const { std::ofstream(file()) << bytes; }

  /// Where event i begins.
  std::size_t offset(std::size_t i) const {
    std::size_t offset = 0;
    for (std::size_t k = 0; k < i; ++k) offset += 28 + log_[k].channel.size() + log_[k].data.size();
    return offset;
  }

  std::vector<LogEvent> log_;
  TemporaryFolder folder_;
};

TEST_F(LogcheckFile, AWholeFileIsComplete) {
  std::int64_t last = 0;
  const LogReport report =
      check_log(file(), [&last](std::int64_t done, std::int64_t) { last = done; });
  EXPECT_EQ(report.verdict(), Verdict::complete);
  EXPECT_EQ(report.events, 22);
  EXPECT_EQ(report.size, last);
}

TEST_F(LogcheckFile, ATruncatedFileIsDamaged) {
  write(bytes().substr(0, offset(15) + 10));
  const LogReport report = check_log(file());
  EXPECT_EQ(report.events, 15);
  EXPECT_EQ(report.verdict(), Verdict::damaged);
  EXPECT_EQ(exit_code(report), 1);
  EXPECT_THAT(report.damage, ElementsAre(LogDamage{static_cast<std::int64_t>(offset(15)), 10}));
}

TEST_F(LogcheckFile, DamageInTheMiddleCostsOneMessage) {
  std::string damaged = bytes();
  damaged[offset(7)] = 'x';
  write(damaged);
  const LogReport report = check_log(file());
  EXPECT_EQ(report.events, 21);
  ASSERT_EQ(report.damage.size(), 1U);
  EXPECT_EQ(report.damage[0].offset, static_cast<std::int64_t>(offset(7)));
  EXPECT_EQ(report.channels[0].channel, "PICO_LASER");
  EXPECT_THAT(report.channels[0].sessions[0].missing, ElementsAre(SeqRange{6, 6}));
}

TEST_F(LogcheckFile, AHugeLengthCostsOneMessage) {
  std::string damaged = bytes();
  damaged.replace(offset(7) + 24, 4, "\x7F\xFF\xFF\xFF");
  write(damaged);
  const LogReport report = check_log(file());
  EXPECT_EQ(report.events, 21);
  EXPECT_EQ(report.channels[0].missing, 1);
}

TEST_F(LogcheckFile, AnEmptyFileProvesNothing) {
  write("");
  const LogReport report = check_log(file());
  EXPECT_EQ(report.events, 0);
  EXPECT_EQ(report.verdict(), Verdict::not_provable);
  EXPECT_EQ(exit_code(report), 3);
}

TEST_F(LogcheckFile, AnAbsentFileIsAnError) {
  EXPECT_THROW(check_log(folder_ / "absent.lcmlog"), LogError);
}

}  // namespace
}  // namespace perceptor
