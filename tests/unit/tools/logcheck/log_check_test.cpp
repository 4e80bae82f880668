#include "tools/logcheck/log_check.hpp"

#include <limits>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <pico/status_t.hpp>

#include "tests/unit/tools/logcheck/fake_publisher.hpp"

namespace perceptor {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

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

TEST_F(Logcheck, WhatTheNetworkDeliversTwiceDoesNotStandForWhatIsMissing) {
  Publisher locate(log_, "locate", 1);
  locate.status();
  locate.position(10, 0);
  locate.position(10, 1);
  log_.push_back(LogEvent(log_.back()));
  locate.position(10, 2, false);
  locate.status(true);
  EXPECT_EQ(channel("POSITION").missing, 1);
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

}  // namespace
}  // namespace perceptor
