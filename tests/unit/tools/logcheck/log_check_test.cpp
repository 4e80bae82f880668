#include "tools/logcheck/log_check.hpp"

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <pico/laser_scan_t.hpp>
#include <pico/position_t.hpp>
#include <pico/status_t.hpp>

#include "common/bus/status.hpp"
#include "tests/support/temporary_folder.hpp"

namespace perceptor {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

template <class Message>
LogEvent event(const std::string& channel, const Message& message) {
  LogEvent e;
  e.channel = channel;
  e.timestamp = message.utime;
  e.data.resize(static_cast<std::size_t>(message.getEncodedSize()));
  message.encode(e.data.data(), 0, static_cast<int>(e.data.size()));
  return e;
}

/// One start of a component that counts what it publishes, as the real ones do; `log` is what
/// the logger caught.
class Publisher {
 public:
  Publisher(std::vector<LogEvent>& log, const std::string& component, std::int64_t boot)
      : log_(log), status_(component, boot) {}

  void scan(std::int64_t session, std::int64_t seq, bool caught = true) {
    pico::laser_scan_t message{};
    message.num_ranges = 1;
    message.ranges = {1.0F};
    send("PICO_LASER", message, session, seq, caught);
  }

  void position(std::int64_t session, std::int64_t seq, bool caught = true) {
    send("POSITION", pico::position_t{}, session, seq, caught);
  }

  void status(bool last = false, bool caught = true) {
    const auto message = status_.message(static_cast<std::int64_t>(log_.size()) * 1000, last);
    if (caught) log_.push_back(event(status_.channel(), message));
  }

 private:
  template <class Message>
  void send(const std::string& channel, Message message, std::int64_t session, std::int64_t seq,
            bool caught) {
    set_stamp(message, {static_cast<std::int64_t>(log_.size()) * 1000, session, seq});
    status_.published(channel, stamp_of(message));
    if (caught) log_.push_back(event(channel, message));
  }

  std::vector<LogEvent>& log_;
  Status status_;
};

class Logcheck : public ::testing::Test {
 protected:
  LogReport check() const {
    LogCheck check;
    for (const LogEvent& e : log_) check.add(e);
    return check.report();
  }

  ChannelReport channel(const std::string& name) const {
    for (const ChannelReport& report : check().channels)
      if (report.channel == name) return report;
    ADD_FAILURE() << name << " is not reported";
    return {};
  }

  std::vector<LogEvent> log_;
};

TEST_F(Logcheck, AWholeRunIsComplete) {
  Publisher bridge(log_, "bridge", 1);
  Publisher locate(log_, "locate", 2);
  bridge.status();
  locate.status();
  for (int i = 0; i < 50; ++i) {
    bridge.scan(10, i);
    if (i % 3 != 0) locate.position(10, i);  // gaps are legitimate here
    if (i % 20 == 19) {
      bridge.status();
      locate.status();
    }
  }
  bridge.status(true);
  locate.status(true);
  const LogReport report = check();
  EXPECT_EQ(report.verdict(), Verdict::complete);
  EXPECT_EQ(exit_code(report), 0);
  for (const ChannelReport& channel : report.channels) {
    EXPECT_EQ(channel.verdict, Verdict::complete) << channel.channel;
    EXPECT_THAT(channel.reasons, IsEmpty()) << channel.channel;
  }
  EXPECT_EQ(channel("PICO_LASER").count, 50);
  EXPECT_EQ(channel("PICO_LASER").sessions.size(), 1U);
}

TEST_F(Logcheck, AGapInASourceIsMissingAndNamed) {
  Publisher bridge(log_, "bridge", 1);
  bridge.status();
  for (int i = 0; i < 20; ++i) bridge.scan(10, i, i != 0 && i != 7 && i != 8 && i != 19);
  bridge.status(true);
  const ChannelReport laser = channel("PICO_LASER");
  EXPECT_EQ(laser.verdict, Verdict::missing);
  EXPECT_EQ(laser.missing, 4);
  EXPECT_THAT(laser.sessions[0].missing,
              ElementsAre(SeqRange{0, 0}, SeqRange{7, 8}, SeqRange{19, 19}));
  EXPECT_THAT(laser.reasons, ElementsAre("4 missing from session 10: seq 0, 7..8, 19"));
  EXPECT_EQ(exit_code(check()), 1);
}

TEST_F(Logcheck, ALostComputedMessageIsMissingByItsPublishersCount) {
  Publisher locate(log_, "locate", 2);
  locate.status();
  for (int i = 0; i < 30; ++i) {
    locate.position(10, 2 * i, i != 15 && i != 16);
    if (i % 10 == 9) locate.status();
  }
  locate.status(true);
  const ChannelReport position = channel("POSITION");
  EXPECT_EQ(position.verdict, Verdict::missing);
  EXPECT_EQ(position.missing, 2);
  ASSERT_EQ(position.losses.size(), 1U);
  EXPECT_EQ(position.losses[0].count, 2);
  EXPECT_LT(position.losses[0].from, position.losses[0].to);
  EXPECT_THAT(position.reasons, ElementsAre(HasSubstr("published 30, 2 are missing")));
}

TEST_F(Logcheck, AChannelOfWhichNothingArrivedIsMissing) {
  Publisher locate(log_, "locate", 2);
  locate.status();
  for (int i = 0; i < 5; ++i) locate.position(10, i, false);
  locate.status(true);
  const ChannelReport position = channel("POSITION");
  EXPECT_EQ(position.count, 0);
  EXPECT_EQ(position.missing, 5);
  EXPECT_EQ(position.verdict, Verdict::missing);
}

TEST_F(Logcheck, WithoutStatusTheEndIsNotProvable) {
  Publisher bridge(log_, "bridge", 1);
  for (int i = 0; i < 5; ++i) bridge.scan(10, i);
  const ChannelReport laser = channel("PICO_LASER");
  EXPECT_EQ(laser.verdict, Verdict::not_provable);
  EXPECT_THAT(laser.reasons, ElementsAre("no STATUS of its publisher in the log"));
  EXPECT_EQ(exit_code(check()), 3);
}

TEST_F(Logcheck, AKilledPublisherProvesNothingAboutItsEnd) {
  Publisher locate(log_, "locate", 2);
  locate.status();
  for (int i = 0; i < 5; ++i) locate.position(10, i);
  locate.status();
  locate.position(10, 5);
  Publisher again(log_, "locate", 3);
  again.status();
  for (int i = 6; i < 9; ++i) again.position(10, i);
  again.status(true);
  const ChannelReport position = channel("POSITION");
  EXPECT_EQ(position.verdict, Verdict::not_provable);
  EXPECT_THAT(position.reasons, ElementsAre(HasSubstr("boot 2) sent no last STATUS")));
  const ChannelReport status = channel("STATUS_LOCATE");
  EXPECT_EQ(status.verdict, Verdict::not_provable);
  EXPECT_THAT(status.reasons, ElementsAre(HasSubstr("boot 2")));
  EXPECT_EQ(status.sessions.size(), 2U);
}

TEST_F(Logcheck, APublisherThatStoppedAndCameBackIsComplete) {
  for (const std::int64_t boot : {1, 2, 3}) {
    Publisher bridge(log_, "bridge", boot);
    bridge.status();
    for (int i = 0; i < 5; ++i) bridge.scan(100 + boot, i);
    bridge.status(true);
  }
  EXPECT_EQ(check().verdict(), Verdict::complete);
  EXPECT_EQ(channel("PICO_LASER").sessions.size(), 3U);
}

TEST_F(Logcheck, WhatWasLostAfterTheLastStatusButOneIsSeenInTheLast) {
  Publisher locate(log_, "locate", 2);
  locate.status();
  locate.position(10, 0);
  locate.position(10, 1, false);
  locate.status(true);
  EXPECT_EQ(channel("POSITION").missing, 1);
}

TEST_F(Logcheck, ALogThatBeganLateIsNotProvable) {
  std::vector<LogEvent> before;
  Publisher bridge(log_, "bridge", 1);
  Publisher locate(log_, "locate", 2);
  for (int i = 0; i < 5; ++i) {
    bridge.scan(10, i, false);
    locate.position(10, i, false);
  }
  bridge.status(false, false);
  locate.status(false, false);
  bridge.status();
  locate.status();
  for (int i = 5; i < 9; ++i) {
    bridge.scan(10, i);
    locate.position(10, i);
  }
  bridge.status(true);
  locate.status(true);
  EXPECT_EQ(exit_code(check()), 3);
  EXPECT_THAT(channel("POSITION").reasons,
              ElementsAre(HasSubstr("began after locate (boot 2), which had published 5")));
  EXPECT_THAT(channel("PICO_LASER").reasons, Contains("the log began at seq 5"));
  EXPECT_EQ(channel("PICO_LASER").missing, 0);
  EXPECT_THAT(channel("STATUS_LOCATE").reasons, ElementsAre("the log began at seq 1"));
}

TEST_F(Logcheck, OneLastStatusWithTheFullCountIsProofEnough) {
  Publisher convert(log_, "convert", 1);
  for (int i = 0; i < 5; ++i) convert.scan(10, i);
  convert.status(true);
  EXPECT_EQ(check().verdict(), Verdict::complete);
}

TEST_F(Logcheck, ALostStatusIsMissing) {
  Publisher locate(log_, "locate", 2);
  for (int i = 0; i < 5; ++i) locate.status(false, i != 3);
  locate.status(true);
  const ChannelReport status = channel("STATUS_LOCATE");
  EXPECT_EQ(status.verdict, Verdict::missing);
  EXPECT_THAT(status.reasons, ElementsAre("1 missing from boot 2: seq 3"));
}

TEST_F(Logcheck, AGapThatThePublisherPassedOnIsSaidSo) {
  // A recording with a hole, published again: the publisher sent all it had.
  Publisher bridge(log_, "bridge", 1);
  bridge.status();
  for (const int seq : {0, 1, 4, 5}) bridge.scan(10, seq);
  bridge.status(true);
  const ChannelReport laser = channel("PICO_LASER");
  EXPECT_EQ(laser.verdict, Verdict::missing);
  EXPECT_EQ(laser.missing, 2);
  EXPECT_THAT(laser.reasons, Contains(HasSubstr("lost before the publisher")));
}

TEST_F(Logcheck, TwoPublishersAtOnceProveNothing) {
  Publisher one(log_, "locate", 1);
  Publisher two(log_, "locate", 2);
  for (int i = 0; i < 3; ++i) {
    one.position(10, i);
    two.position(10, i);
    one.status();
    two.status();
  }
  one.status(true);
  two.status(true);
  EXPECT_THAT(channel("POSITION").reasons, ElementsAre("two publishers at once"));
}

TEST_F(Logcheck, MessagesThatNobodyCountedAreSaidSo) {
  Publisher locate(log_, "locate", 2);
  Publisher stranger(log_, "stranger", 3);
  stranger.position(9, 0);
  locate.status();
  locate.position(10, 0);
  stranger.position(9, 1);
  locate.status(true);
  stranger.position(9, 2);
  EXPECT_THAT(channel("POSITION").reasons,
              ElementsAre(HasSubstr("1 message before the first STATUS"),
                          HasSubstr("1 more in the log than"),
                          HasSubstr("1 message after the last STATUS")));
  EXPECT_EQ(channel("POSITION").verdict, Verdict::not_provable);
}

TEST_F(Logcheck, LossBeforeARestartedPublishersFirstStatusIsMissing) {
  Publisher locate(log_, "locate", 2);
  locate.status();
  locate.position(10, 0);
  locate.status(true);
  Publisher again(log_, "locate", 3);
  again.status(false, false);
  again.position(10, 1, false);
  again.status();
  again.status(true);
  EXPECT_EQ(channel("POSITION").missing, 1);
  EXPECT_THAT(channel("POSITION").reasons, ElementsAre(HasSubstr("before the first STATUS of")));
}

TEST_F(Logcheck, RepeatedMessagesAreCounted) {
  Publisher bridge(log_, "bridge", 1);
  bridge.scan(10, 0);
  bridge.scan(10, 0);
  bridge.scan(10, 1);
  bridge.status(true);
  EXPECT_EQ(channel("PICO_LASER").sessions[0].repeated, 1);
  EXPECT_EQ(channel("PICO_LASER").verdict, Verdict::complete);
}

TEST_F(Logcheck, AMessageThatCannotBeDecodedIsDamage) {
  Publisher bridge(log_, "bridge", 1);
  bridge.status();
  for (int i = 0; i < 3; ++i) bridge.scan(10, i);
  bridge.status(true);
  log_[2].data.pop_back();                       // a truncated scan
  log_[1].data = log_[0].data;                   // another type
  log_[0].data.resize(log_[0].data.size() / 2);  // a truncated STATUS
  const ChannelReport laser = channel("PICO_LASER");
  EXPECT_EQ(laser.verdict, Verdict::damaged);
  EXPECT_EQ(laser.undecodable.size(), 2U);
  EXPECT_EQ(channel("STATUS_BRIDGE").verdict, Verdict::damaged);
  EXPECT_EQ(exit_code(check()), 1);
}

TEST_F(Logcheck, HostileNumbersDoNoHarm) {
  Publisher bridge(log_, "bridge", 1);
  bridge.scan(10, -1);
  bridge.scan(10, std::numeric_limits<std::int64_t>::max());
  bridge.scan(10, std::numeric_limits<std::int64_t>::min());
  for (int session = 0; session < 64; ++session) bridge.scan(session, std::int64_t{1} << 60U);
  const ChannelReport laser = channel("PICO_LASER");
  EXPECT_EQ(laser.undecodable.at("sequence number out of range"), 3);
  EXPECT_GT(laser.missing, 0);
}

TEST_F(Logcheck, AStatusThatMakesNoSenseIsDamage) {
  pico::status_t status{};
  status.component = "bridge";
  status.num_outputs = 1;
  status.outputs.emplace_back();
  status.outputs[0].channel = "PICO_LASER";
  status.outputs[0].published = -5;
  log_.push_back(event("STATUS_BRIDGE", status));
  EXPECT_EQ(channel("STATUS_BRIDGE").undecodable.at("output out of range"), 1);
}

TEST_F(Logcheck, ForeignChannelsAreSaidToBeSo) {
  LogEvent foreign;
  foreign.channel = "CAMERA";
  foreign.data = {1, 2, 3};
  log_.push_back(foreign);
  EXPECT_THAT(channel("CAMERA").reasons, ElementsAre(HasSubstr("no channel of ours")));
  EXPECT_EQ(exit_code(check()), 3);
}

TEST_F(Logcheck, LcmsOwnSelfTestDoesNotCount) {
  Publisher bridge(log_, "bridge", 1);
  bridge.scan(10, 0);
  bridge.status(true);
  LogEvent self_test;
  self_test.channel = "LCM_SELF_TEST";
  self_test.timestamp = 5;
  log_.push_back(self_test);
  EXPECT_EQ(channel("LCM_SELF_TEST").verdict, Verdict::not_checked);
  EXPECT_EQ(exit_code(check()), 0);
}

TEST_F(Logcheck, LargeStepsBackOfTheStampsAreListed) {
  for (const std::int64_t stamp : {0, 5'000'000, 4'999'000, 4'000'000, 1'000'000, 6'000'000}) {
    LogEvent e;
    e.channel = "LCM_SELF_TEST";
    e.timestamp = stamp;
    log_.push_back(e);
  }
  const LogReport report = check();
  EXPECT_EQ(report.step_backs, 1);
  ASSERT_EQ(report.first_step_backs.size(), 1U);
  EXPECT_EQ(report.first_step_backs[0].event, 4);
  EXPECT_EQ(report.first_step_backs[0].from, 4'000'000);
  EXPECT_EQ(report.first_step_backs[0].to, 1'000'000);
  EXPECT_NEAR(report.duration, 6.0, 1e-9);
  EXPECT_NEAR(report.channels[0].rate, 5.0 / 6.0, 1e-9);
}

/// The same through a file.
class LogcheckFile : public Logcheck {
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

  testing::TemporaryFolder folder_;
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
