#include "tools/convert/conversion.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <pico/laser_scan_t.hpp>
#include <pico/odometry_t.hpp>
#include <pico/status_t.hpp>

#include "common/messages/schema.hpp"
#include "common/messages/validate.hpp"
#include "tools/temporary_folder.hpp"

namespace perceptor {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A robot that moves along x and sees three beams.
const std::string kSmall =
    "# scanlog 1\n"
    "# laser_pose 0.1 0 0\n"
    "# valid_min 0.05\n"
    "# valid_max 19\n"
    "ODOM 1.0 0 0 0\n"
    "ODOM 1.2 0.1 0 0\n"
    "LASER 1.1 -0.5 0.5 20 3 1 nan 20\n"
    "ODOM 1.3 0.2 0 0\n"
    "LASERA 1.25 20 2 0.5 1 -0.5 2\n";

class Conversion : public ::testing::Test {
 protected:
  struct Messages {
    std::vector<pico::laser_scan_t> scans;
    std::vector<pico::odometry_t> odometry;
    std::vector<pico::status_t> statuses;
    std::vector<std::int64_t> stamps;
    std::vector<std::string> channels;
  };

  std::filesystem::path out() const { return folder_ / "out.lcmlog"; }

  ConversionSummary convert_text(const std::string& text, const ConversionOptions& options = {},
                                 const std::string& name = "in.log") const {
    std::istringstream in(text);
    return convert(in, name, out(), options);
  }

  std::string bytes() const {
    std::ifstream in(out());
    return {std::istreambuf_iterator<char>(in), {}};
  }

  template <class Message>
  static void take(const LogEvent& event, std::vector<Message>& messages) {
    EXPECT_EQ(messages::find_fault<Message>(event.data), "");
    Message message;
    message.decode(event.data.data(), 0, static_cast<int>(event.data.size()));
    EXPECT_EQ(messages::validate(message), "");
    messages.push_back(message);
  }

  Messages read() const {
    Messages messages;
    LogReader reader(out());
    for (LogEvent event; reader.next(event);) {
      messages.stamps.push_back(event.timestamp);
      messages.channels.push_back(event.channel);
      if (event.channel == "PICO_LASER") take(event, messages.scans);
      if (event.channel == "PICO_ODOMETRY") take(event, messages.odometry);
      if (event.channel == "STATUS_CONVERT") take(event, messages.statuses);
    }
    EXPECT_THAT(reader.damage(), IsEmpty());
    return messages;
  }

  TemporaryFolder folder_;
};

TEST_F(Conversion, WritesWhatWasRecorded) {
  const ConversionSummary summary = convert_text(kSmall);
  EXPECT_EQ(summary.lines, 9);
  EXPECT_EQ(summary.scans, 2);
  EXPECT_EQ(summary.odometry, 3);
  EXPECT_EQ(summary.session, 1'000'000);
  EXPECT_NEAR(summary.duration, 0.3, 1e-9);
  EXPECT_TRUE(summary.dropped.empty());
  EXPECT_THAT(summary.notes, IsEmpty());

  const Messages log = read();
  ASSERT_EQ(log.scans.size(), 2U);
  const pico::laser_scan_t& scan = log.scans[0];
  EXPECT_EQ(scan.utime, 1'100'000);
  EXPECT_EQ(scan.session, 1'000'000);
  EXPECT_EQ(scan.seq, 0);
  EXPECT_EQ(scan.laser_in_robot.x, 0.1);
  EXPECT_EQ(scan.angle_max, 0.5);
  EXPECT_EQ(scan.valid_min, 0.05);
  EXPECT_EQ(scan.valid_max, 19.0);
  EXPECT_EQ(scan.range_sigma, 0.01);
  EXPECT_EQ(scan.time_increment, 0.0);
  EXPECT_EQ(scan.ranges[0], 1.0F);
  EXPECT_TRUE(std::isnan(scan.ranges[1]));
  EXPECT_EQ(scan.ranges[2], 20.0F);
  EXPECT_THAT(log.scans[1].bearings, ElementsAre(0.5F, -0.5F));
  EXPECT_EQ(log.scans[1].angle_increment, 0.0);
  EXPECT_EQ(log.scans[1].seq, 1);
  ASSERT_EQ(log.odometry.size(), 3U);
  EXPECT_EQ(log.odometry[2].seq, 2);
  EXPECT_EQ(log.odometry[2].robot_in_odometry.x, 0.2);
}

TEST_F(Conversion, StampsOnlyGoForwardWhileUtimesStay) {
  convert_text(kSmall);
  EXPECT_THAT(read().stamps,
              ElementsAre(1'000'000, 1'200'000, 1'200'000, 1'300'000, 1'300'000, 1'300'000));
}

TEST_F(Conversion, TheLastWordCountsWhatWasWritten) {
  convert_text(kSmall + "WHAT 1\nODOM 1 2\nODOM 1 2 3\n");
  const Messages log = read();
  EXPECT_EQ(log.channels.back(), "STATUS_CONVERT");
  ASSERT_EQ(log.statuses.size(), 1U);
  const pico::status_t& status = log.statuses[0];
  EXPECT_EQ(status.component, "convert");
  EXPECT_EQ(status.utime, 1'300'000);
  EXPECT_EQ(status.seq, 0);
  EXPECT_TRUE(status.last);
  ASSERT_EQ(status.num_outputs, 2);
  EXPECT_EQ(status.outputs[0].channel, "PICO_LASER");
  EXPECT_EQ(status.outputs[0].published, 2);
  EXPECT_EQ(status.outputs[0].last_seq, 1);
  EXPECT_EQ(status.outputs[0].session, 1'000'000);
  EXPECT_EQ(status.outputs[1].published, 3);
  ASSERT_EQ(status.num_rejects, 2);
  EXPECT_EQ(status.rejects[0].reason, "unknown keyword");
  EXPECT_EQ(status.rejects[1].reason, "wrong count");
  EXPECT_EQ(status.rejects[1].count, 2);
}

TEST_F(Conversion, TwiceGivesTheSameBytes) {
  convert_text(kSmall);
  const std::string first = bytes();
  convert_text(kSmall);
  EXPECT_EQ(bytes(), first);
}

TEST_F(Conversion, OptionsGoIntoTheMessages) {
  ConversionOptions options;
  options.events.session = 7;
  options.events.range_sigma = 0.03;
  options.events.time_increment = 0.001;
  options.events.valid_min = 0.2;
  options.events.valid_max = 5.0;
  convert_text(kSmall, options);
  const Messages log = read();
  EXPECT_EQ(log.odometry[0].session, 7);
  EXPECT_EQ(log.scans[0].session, 7);
  EXPECT_EQ(log.scans[0].range_sigma, 0.03);
  EXPECT_EQ(log.scans[0].time_increment, 0.001);
  EXPECT_EQ(log.scans[0].valid_min, 0.2);
  EXPECT_EQ(log.scans[0].valid_max, 5.0);
}

TEST_F(Conversion, ASessionIsNeverZero) { EXPECT_EQ(convert_text("ODOM 0 0 0 0\n").session, 1); }

TEST_F(Conversion, AStandingRobotHasZerosAroundEveryScan) {
  ConversionOptions options;
  options.events.still = true;
  const ConversionSummary summary = convert_text(
      "LASER 5 0 0.1 20 1 1\nLASER 5.1 0 0.1 20 1 1\nLASER 20 0 0.1 20 1 1\n", options);
  EXPECT_EQ(summary.odometry, 5);
  const Messages log = read();
  std::vector<std::int64_t> utimes;
  std::int64_t seq = 0;
  for (const pico::odometry_t& odometry : log.odometry) {
    utimes.push_back(odometry.utime);
    EXPECT_EQ(odometry.seq, seq++);
    EXPECT_EQ(odometry.robot_in_odometry.x, 0.0);
    EXPECT_EQ(odometry.robot_in_odometry.y, 0.0);
    EXPECT_EQ(odometry.robot_in_odometry.a, 0.0);
  }
  EXPECT_THAT(utimes, ElementsAre(4'980'000, 5'000'000, 5'100'000, 20'000'000, 20'020'000));
  EXPECT_EQ(log.statuses[0].utime, 20'020'000);
}

TEST_F(Conversion, AStandingRobotsFirstScanMayBeAtZero) {
  ConversionOptions options;
  options.events.still = true;
  EXPECT_EQ(convert_text("LASER 0 0 0.1 20 1 1\n", options).odometry, 2);
}

TEST_F(Conversion, StillReplacesRecordedOdometry) {
  ConversionOptions options;
  options.events.still = true;
  const ConversionSummary summary = convert_text(kSmall, options);
  EXPECT_EQ(summary.dropped.at(drop_reason::replaced).count, 3);
  for (const pico::odometry_t& odometry : read().odometry)
    EXPECT_EQ(odometry.robot_in_odometry.x, 0.0);
}

TEST_F(Conversion, SaysThatAScanWithoutOdometryIsOfNoUse) {
  EXPECT_THAT(convert_text("# valid_max 19\nLASER 1 0 0.1 20 1 1\n").notes,
              Contains(HasSubstr("--still")));
}

TEST_F(Conversion, DerivesTheValidRangeAndSaysSo) {
  const ConversionSummary summary =
      convert_text("# valid_max 0\nODOM 1 0 0 0\nLASER 1 0 0.1 20 1 1\n");
  EXPECT_THAT(summary.notes, ElementsAre(HasSubstr("valid_min"), HasSubstr("19.8 m")));
  EXPECT_NEAR(read().scans[0].valid_max, 19.8, 1e-9);
}

TEST_F(Conversion, DropsAScanWhoseValidRangeNobodyKnows) {
  const std::string text = "ODOM 1 0 0 0\nLASER 1 0 0.1 0 1 1\nLASER 2 0 0.1 inf 1 1\n";
  EXPECT_EQ(convert_text(text).dropped.at(drop_reason::no_valid_range).count, 2);
  ConversionOptions options;
  options.events.valid_max = 10.0;
  EXPECT_EQ(convert_text(text, options).scans, 2);
}

TEST_F(Conversion, DropsWhatEveryComponentWouldReject) {
  // Three beams that all point one way; a pose beyond any world.
  const ConversionSummary summary =
      convert_text("ODOM 1 0 0 0\nODOM 2 1e9 0 0\nLASER 1 0 0 20 3 1 1 1\n");
  EXPECT_EQ(summary.scans, 0);
  EXPECT_EQ(summary.odometry, 1);
  EXPECT_EQ(summary.dropped.size(), 2U);
  EXPECT_EQ(read().odometry.size(), 1U);
}

TEST_F(Conversion, CountsDroppedLinesAndNamesTheFirst) {
  std::string text = "ODOM 1 0 0 0\n";
  for (int i = 0; i < 8; ++i) text += "FOO " + std::to_string(i) + "\n";
  text += "ODOM 1 x 0 0\n";
  const ConversionSummary summary = convert_text(text, {RecordingFormat::text, {}});
  const DroppedLines& unknown = summary.dropped.at(drop_reason::unknown_keyword);
  EXPECT_EQ(unknown.count, 8);
  EXPECT_THAT(unknown.first, ElementsAre("2: FOO", "3: FOO", "4: FOO", "5: FOO", "6: FOO"));
  std::ostringstream out;
  print(out, summary);
  EXPECT_THAT(out.str(), HasSubstr("0 scans, 1 odometry written"));
  EXPECT_THAT(out.str(), HasSubstr("dropped 8, unknown keyword: lines 2: FOO; 3: FOO"));
  EXPECT_THAT(out.str(), HasSubstr("; ...\n"));
  EXPECT_THAT(out.str(), HasSubstr("dropped 1, bad number: line 10: x\n"));
}

TEST_F(Conversion, NothingUsefulLeavesTheOutputAlone) {
  std::ofstream(out()) << "precious";
  EXPECT_FALSE(convert_text("").is_useful());
  EXPECT_FALSE(convert_text("some prose\n\n# a remark\n").is_useful());
  EXPECT_EQ(bytes(), "precious");
}

TEST_F(Conversion, SaysHowToUnpack) {
  const auto failure = [this](const std::string& text, const std::string& name) {
    try {
      convert_text(text, {}, name);
    } catch (const NotARecording& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_THAT(failure(std::string("\xFD"
                                  "7zXZ\0\0\4",
                                  8),
                      "a.log.xz"),
              HasSubstr("xz -dc a.log.xz | pico-convert - "));
  EXPECT_THAT(failure("\x1F\x8B\b", "-"), HasSubstr("gzip -dc FILE | pico-convert - "));
  EXPECT_THAT(failure("BZh9", "a.bag.bz2"), HasSubstr("bzip2 -dc a.bag.bz2 > FILE.bag"));
  EXPECT_THAT(failure("BZh9", "a"), HasSubstr("bzip2 -dc"));
  EXPECT_THAT(failure("\x28\xB5\x2F\xFD", "a"), HasSubstr("zstd -dc"));
  EXPECT_THAT(failure("\xED\xA1\xDA\x01", "a"), HasSubstr("an LCM event log already"));
  EXPECT_THAT(failure("#ROSBAG V2.0\n", "a"), HasSubstr("a ROS bag"));
}

TEST_F(Conversion, TellsTheFormatsApart) {
  // Both begin with a comment and an ODOM line.
  EXPECT_EQ(convert_text("# a remark\nODOM 1 2 0.5 5\n").odometry, 1);
  EXPECT_EQ(read().odometry[0].utime, 1'000'000);
  EXPECT_EQ(
      convert_text("# message_name [message contents]\nODOM 1 2 0.5 0 0 0 5 host 0.1\n").odometry,
      1);
  EXPECT_EQ(read().odometry[0].utime, 5'000'000);
  EXPECT_EQ(convert_text("PARAM a b\nFLASER 1 1 0 0 0 0 0 0 5 host 0.1\n").scans, 1);
  EXPECT_EQ(convert_text("FLASER 1 1 0 0 0 0 0 0 5\n", {RecordingFormat::text, {}}).scans, 0);
  EXPECT_EQ(convert_text("ODOM 1 2 0.5 0 0 0 5\n", {RecordingFormat::carmen, {}}).odometry, 1);
}

TEST_F(Conversion, AnEndlessLineIsDroppedAndTheNextOneRead) {
  const ConversionSummary summary =
      convert_text("ODOM 1 0 0 0\n" + std::string(5'000'000, 'x') + "\nODOM 2 0 0 0");
  EXPECT_EQ(summary.odometry, 2);
  EXPECT_EQ(summary.lines, 3);
  EXPECT_EQ(summary.dropped.at(drop_reason::too_long).count, 1);
}

TEST_F(Conversion, ReportsProgressInBytes) {
  std::istringstream in(kSmall);
  std::int64_t last = 0;
  convert(in, "in.log", out(), {}, [&last](std::int64_t bytes) {
    EXPECT_GT(bytes, last);
    last = bytes;
  });
  EXPECT_EQ(static_cast<std::size_t>(last), kSmall.size());
}

TEST_F(Conversion, AnOutputThatCannotBeWrittenIsAnError) {
  std::istringstream in(kSmall);
  EXPECT_THROW(convert(in, "in.log", folder_ / "absent/out.lcmlog", {}), LogError);
}

}  // namespace
}  // namespace perceptor
