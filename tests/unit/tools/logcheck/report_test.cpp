#include "tools/logcheck/report.hpp"

#include <sstream>
#include <string>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace perceptor {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

ChannelReport channel(const std::string& name, Verdict verdict) {
  ChannelReport report;
  report.channel = name;
  report.verdict = verdict;
  return report;
}

std::string printed(const LogReport& report) {
  std::ostringstream out;
  print(out, report);
  return out.str();
}

TEST(LogReport, TheWorstChannelDecides) {
  LogReport report;
  report.events = 1;
  report.channels = {channel("A", Verdict::complete), channel("B", Verdict::not_checked)};
  EXPECT_EQ(report.verdict(), Verdict::complete);
  EXPECT_EQ(exit_code(report), 0);
  report.channels.push_back(channel("C", Verdict::not_provable));
  EXPECT_EQ(exit_code(report), 3);
  report.channels.push_back(channel("D", Verdict::missing));
  EXPECT_EQ(exit_code(report), 1);
  report.channels.push_back(channel("E", Verdict::damaged));
  EXPECT_EQ(report.verdict(), Verdict::damaged);
  EXPECT_EQ(exit_code(report), 1);
}

TEST(LogReport, ADamagedFileIsDamagedWhateverItsChannels) {
  LogReport report;
  report.events = 1;
  report.size = 100;
  report.damage = {{90, 10}};
  report.channels = {channel("A", Verdict::complete)};
  EXPECT_EQ(report.verdict(), Verdict::damaged);
  EXPECT_THAT(printed(report), HasSubstr("damaged: 10 of 100 bytes hold no event"));
  EXPECT_THAT(printed(report), HasSubstr("at byte 90: 10 bytes, to the end"));
}

TEST(LogReport, PrintsALineForEachChannelAndReason) {
  LogReport report;
  report.events = 3;
  report.size = 300;
  ChannelReport laser = channel("PICO_LASER", Verdict::missing);
  laser.count = 3;
  laser.missing = 2;
  laser.rate = 40.04;
  laser.sessions.resize(1);
  laser.reasons = {"2 missing from session 7: seq 4..5"};
  laser.losses = {{2, 1'000'000, 2'500'000}};
  report.channels = {laser, channel("POSITION", Verdict::complete)};
  report.step_backs = 1;
  report.first_step_backs = {{2, 9'000'000, 1'000'000}};
  const std::string text = printed(report);
  EXPECT_THAT(text, HasSubstr("PICO_LASER         3      40.0         1        2  missing\n"));
  EXPECT_THAT(text, HasSubstr("POSITION           0       0.0         0        0  complete\n"));
  EXPECT_THAT(text, HasSubstr("PICO_LASER: 2 missing from session 7: seq 4..5\n"));
  EXPECT_THAT(text, HasSubstr("2 of them from 1.000 s to 2.500 s\n"));
  EXPECT_THAT(text, HasSubstr("at event 2: from 9.000 s to 1.000 s\n"));
  EXPECT_THAT(text, HasSubstr("verdict: missing\n"));
}

TEST(LogReport, LongListsAreCut) {
  LogReport report;
  report.events = 1;
  ChannelReport laser = channel("PICO_LASER", Verdict::not_provable);
  laser.reasons.assign(14, "because");
  report.channels = {laser};
  for (int i = 0; i < 15; ++i) report.damage.push_back({2 * i, 1});
  EXPECT_THAT(printed(report), HasSubstr("PICO_LASER: and 4 more\n"));
  EXPECT_THAT(printed(report), HasSubstr("and 5 more places\n"));
}

TEST(LogReport, AnEmptyLogAndAFileThatIsNoneAreToldApart) {
  LogReport report;
  EXPECT_THAT(printed(report), HasSubstr("the log is empty"));
  report.size = 12;
  report.damage = {{0, 12}};
  EXPECT_THAT(printed(report), HasSubstr("Is this an LCM event log?"));
  EXPECT_THAT(printed(report), Not(HasSubstr("the log is empty")));
}

TEST(LogReport, JsonHoldsTheSame) {
  LogReport report;
  report.events = 3;
  report.size = 300;
  report.duration = 1.5;
  report.damage = {{90, 10}};
  ChannelReport laser = channel("PICO_LASER", Verdict::missing);
  laser.count = 3;
  laser.missing = 2;
  laser.undecodable = {{"wrong fingerprint", 1}};
  laser.sessions = {{7, 3, 0, 6, 0, {{4, 5}}}};
  laser.losses = {{2, 10, 20}};
  report.channels = {laser};
  const auto json = nlohmann::json::parse(to_json(report));
  EXPECT_EQ(json["verdict"], "damaged");
  EXPECT_EQ(json["events"], 3);
  EXPECT_EQ(json["damage"][0]["offset"], 90);
  EXPECT_EQ(json["channels"][0]["channel"], "PICO_LASER");
  EXPECT_EQ(json["channels"][0]["verdict"], "missing");
  EXPECT_EQ(json["channels"][0]["undecodable"]["wrong fingerprint"], 1);
  EXPECT_EQ(json["channels"][0]["sessions"][0]["missing"][0][1], 5);
  EXPECT_EQ(json["channels"][0]["losses"][0]["count"], 2);
}

TEST(LogReport, EveryVerdictHasAWord) {
  EXPECT_EQ(to_string(Verdict::complete), "complete");
  EXPECT_EQ(to_string(Verdict::not_checked), "not checked");
  EXPECT_EQ(to_string(Verdict::not_provable), "not provable");
  EXPECT_EQ(to_string(Verdict::missing), "missing");
  EXPECT_EQ(to_string(Verdict::damaged), "damaged");
}

}  // namespace
}  // namespace perceptor
