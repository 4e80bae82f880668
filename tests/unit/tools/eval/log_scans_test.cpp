#include "tools/eval/log_scans.hpp"

#include <gmock/gmock.h>
#include <pico/laser_scan_t.hpp>

#include "common/bus/bus.hpp"
#include "common/bus/channels.hpp"
#include "tests/unit/tools/eval/text_file.hpp"
#include "tools/temporary_folder.hpp"

namespace perceptor {
namespace {

using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;

/// Three beams, 0.5 rad apart.
pico::laser_scan_t regular(std::int64_t utime) {
  pico::laser_scan_t message{};
  message.utime = utime;
  message.session = 7;
  message.laser_in_robot.x = 0.125;
  message.angle_min = -0.5;
  message.angle_max = 0.5;
  message.angle_increment = 0.5;
  message.valid_min = 0.25;
  message.valid_max = 8.0;
  message.range_sigma = 0.0625;
  message.num_ranges = 3;
  message.ranges = {1.0F, 0.0F, 2.0F};
  return message;
}

/// Two beams with bearings of their own.
pico::laser_scan_t irregular(std::int64_t utime) {
  pico::laser_scan_t message = regular(utime);
  message.angle_min = message.angle_max = message.angle_increment = 0.0;
  message.num_ranges = message.num_bearings = 2;
  message.ranges = {1.5F, 2.5F};
  message.bearings = {0.25F, -1.0F};
  return message;
}

class ReadLogScans : public ::testing::Test {
 protected:
  void write(const std::string& channel, const pico::laser_scan_t& message) {
    const auto bytes = messages::encode(message);
    writer_.write(channel, message.utime, bytes.data(), bytes.size());
  }
  void write_broken() { writer_.write(channel::laser, 0, "broken", 6); }
  LogScans read() {
    writer_.close();
    return read_log_scans(file_, [this](std::int64_t bytes) { read_bytes_ = bytes; });
  }

  TemporaryFolder folder_;
  std::filesystem::path file_ = folder_ / "drive";
  LogWriter writer_{file_};
  std::int64_t read_bytes_ = 0;
};

TEST_F(ReadLogScans, OfAnyNumberOfBeamsWithTheLasersPose) {
  write(channel::laser, regular(1'500'000));
  write("OTHER", regular(1'600'000));
  write(channel::laser, irregular(2'250'000));
  const LogScans log = read();
  EXPECT_FALSE(log.set.has_truth);
  ASSERT_EQ(log.set.scans.size(), 2U);
  const LabelledScan& first = log.set.scans[0];
  EXPECT_EQ(first.id, 0);
  EXPECT_EQ(first.time, 1.5);
  EXPECT_EQ(first.scan.laser_in_robot, (Position{0.125, 0.0, 0.0}));
  EXPECT_EQ(first.scan.valid_min, 0.25);
  EXPECT_EQ(first.scan.range_sigma, 0.0625);
  EXPECT_THAT(first.scan.bearings, ElementsAre(-0.5, 0.0, 0.5));
  EXPECT_THAT(first.scan.ranges, ElementsAre(1.0, 0.0, 2.0));
  const LabelledScan& second = log.set.scans[1];
  EXPECT_EQ(second.id, 1);
  EXPECT_EQ(second.time, 2.25);
  EXPECT_THAT(second.scan.bearings, ElementsAre(0.25, -1.0));
  EXPECT_EQ(log.undecodable, 0);
  EXPECT_TRUE(log.damage.empty());
  EXPECT_EQ(read_bytes_, static_cast<std::int64_t>(std::filesystem::file_size(file_)));
}

TEST_F(ReadLogScans, CountsWhatCannotBeDecodedAndNumbersItToo) {
  write(channel::laser, regular(1));
  write_broken();
  pico::laser_scan_t invalid = regular(2);
  invalid.angle_max = 0.75;
  write(channel::laser, invalid);
  write(channel::laser, regular(3));
  const LogScans log = read();
  ASSERT_EQ(log.set.scans.size(), 2U);
  EXPECT_EQ(log.set.scans[1].id, 3);
  EXPECT_EQ(log.undecodable, 2);
  EXPECT_FALSE(log.first_fault.empty());
}

TEST_F(ReadLogScans, IdsAreUniqueOverSessions) {
  write(channel::laser, regular(1));
  pico::laser_scan_t other_session = regular(2);
  other_session.session = 8;
  write(channel::laser, other_session);
  EXPECT_EQ(read().set.scans[1].id, 1);
}

TEST_F(ReadLogScans, RefusesALogWithoutScans) {
  write("OTHER", regular(1));
  EXPECT_THAT(testing::error_of<LogError>([&] { read(); }),
              EndsWith("holds no PICO_LASER message"));
}

TEST_F(ReadLogScans, SaysWhyNoScanIsGood) {
  write_broken();
  EXPECT_THAT(testing::error_of<LogError>([&] { read(); }), HasSubstr("that can be decoded: "));
}

}  // namespace
}  // namespace perceptor
