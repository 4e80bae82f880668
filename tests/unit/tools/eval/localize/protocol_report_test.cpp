#include "tools/eval/localize/protocol_report.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace perceptor {
namespace {

JudgedTrial trial(std::size_t number, std::optional<double> found, double longest_false) {
  JudgedTrial trial;
  trial.number = number;
  trial.site = "hospital";
  trial.conditions.clutter = 0.2;
  trial.conditions.doors = Doors::flush;
  trial.outcome.found = found;
  trial.outcome.longest_false = longest_false;
  return trial;
}

TEST(ProtocolReport, NamesEachFailureWithItsNumber) {
  const std::string text =
      report({trial(1, 2.0, 0.0), trial(2, std::nullopt, 0.0), trial(3, 5.0, 4.0)});
  EXPECT_EQ(text.find("\n     1 "), std::string::npos);
  EXPECT_NE(text.find("     2  hospital"), std::string::npos);
  EXPECT_NE(text.find("not found"), std::string::npos);
  EXPECT_NE(text.find("elsewhere for 4.0 s"), std::string::npos);
}

TEST(ProtocolReport, JsonCountsLinesAndTrials) {
  const auto json = nlohmann::json::parse(
      report_json({trial(1, 2.0, 0.0), trial(2, std::nullopt, 0.0), trial(3, 12.0, 0.0)}, 7));
  EXPECT_EQ(json["seed"], 7);
  EXPECT_EQ(json["trials"].size(), 3U);
  EXPECT_TRUE(json["trials"][1]["found"].is_null());
  const auto& in_ten_seconds = json["lines"][0];
  EXPECT_EQ(in_ten_seconds["trials"], 3);
  EXPECT_EQ(in_ten_seconds["hits"], 1);
  EXPECT_LT(in_ten_seconds["low"], 1.0 / 3.0);
  EXPECT_GT(in_ten_seconds["high"], 1.0 / 3.0);
}

TEST(ProtocolReport, CountsWhatCouldNotBeToldSoonerApart) {
  JudgedTrial late = trial(1, 12.0, 0.0);
  late.outcome.is_ambiguous_at_first = true;
  const auto json = nlohmann::json::parse(report_json({late, trial(2, 2.0, 0.0)}, 7));
  const auto& in_ten_seconds = json["lines"][0];
  const auto& clear_by_then = json["lines"][1];
  EXPECT_EQ(in_ten_seconds["trials"], 2);
  EXPECT_EQ(in_ten_seconds["hits"], 1);
  EXPECT_EQ(clear_by_then["trials"], 1);
  EXPECT_EQ(clear_by_then["hits"], 1);
}

TEST(ProtocolReport, AmbiguousStartsNeedNotBeFound) {
  JudgedTrial ambiguous = trial(1, std::nullopt, 0.0);
  ambiguous.outcome.is_ambiguous = true;
  EXPECT_EQ(report({ambiguous}).find("failed"), std::string::npos);
}

}  // namespace
}  // namespace perceptor
