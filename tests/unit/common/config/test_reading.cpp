#include <limits>

#include <gmock/gmock.h>

#include "tests/unit/common/config/example.hpp"
#include "tests/unit/common/config/temporary_file.hpp"

namespace perceptor::config {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// Reads `text` into `value`, and gives the error's text.
template <class Struct>
std::string error_of_reading(const std::string& text, Struct& value) {
  const TemporaryFile file(text, "example.json");
  return error_of([&] { load_file(file.path(), bind(value)); });
}

std::string error_of_reading(const std::string& text) {
  Example example;
  return error_of_reading(text, example);
}

TEST(Reading, FillsEveryKindOfField) {
  Example example;
  EXPECT_EQ(error_of_reading(R"({"max_speed": 2.5, "big": -9223372036854775808, "beams": 12,
                                 "enabled": false, "source": "log:a.lcm", "method": "thorough",
                                 "tour": [{"x": 1.5, "word": "hello"}, {}],
                                 "robot": {"limits": {"speed": 0.25}}})",
                             example),
            "");
  EXPECT_EQ(example.max_speed, 2.5);
  EXPECT_EQ(example.big, std::numeric_limits<std::int64_t>::min());
  EXPECT_EQ(example.beams, 12);
  EXPECT_FALSE(example.enabled);
  EXPECT_EQ(example.source, "log:a.lcm");
  EXPECT_EQ(example.method, Method::thorough);
  ASSERT_EQ(example.tour.size(), 2U);
  EXPECT_EQ(example.tour[0].x, 1.5);
  EXPECT_EQ(example.tour[0].word, "hello");
  EXPECT_EQ(example.tour[1].x, 0.0);
  EXPECT_EQ(example.robot.limits.speed, 0.25);
}

TEST(Reading, KeepsDefaultsOfMissingKeys) {
  Example example;
  EXPECT_EQ(error_of_reading("{}", example), "");
  EXPECT_EQ(example.max_speed, 2.0);
  EXPECT_EQ(example.robot.footprint.size(), 8U);
}

TEST(Reading, ReplacesTheElementsOfAList) {
  Example example;
  example.tour = {{1.0, 2.0, "old"}, {3.0, 4.0, "old"}};
  EXPECT_EQ(error_of_reading(R"({"tour": [{"x": 9}]})", example), "");
  ASSERT_EQ(example.tour.size(), 1U);
  EXPECT_EQ(example.tour[0].x, 9.0);
  EXPECT_EQ(example.tour[0].word, "");
}

TEST(Reading, TakesAWholeNumberWhereANumberBelongs) {
  Example example;
  EXPECT_EQ(error_of_reading(R"({"max_speed": 3})", example), "");
  EXPECT_EQ(example.max_speed, 3.0);
}

TEST(Reading, RefusesAFractionWhereAWholeNumberBelongs) {
  for (const char* written : {"1.5", "1.0", "1e3"}) {
    const std::string error = error_of_reading(std::string(R"({"beams": )") + written + "}");
    EXPECT_THAT(error, AllOf(HasSubstr("example.json: /beams is 1"), HasSubstr("whole number"),
                             HasSubstr("without a fraction")))
        << written;
  }
}

TEST(Reading, RefusesIntegersThatDoNotFit) {
  EXPECT_THAT(error_of_reading(R"({"big": 9223372036854775808})"),
              HasSubstr("/big is 9223372036854775808; allowed: a whole number"));
  EXPECT_THAT(error_of_reading(R"({"big": 123456789012345678901234567890})"),
              AllOf(HasSubstr("/big is 1.23"), HasSubstr("at most 64 bits")));
  Example example;
  EXPECT_EQ(error_of_reading(R"({"big": 9223372036854775807})", example), "");
  EXPECT_EQ(example.big, std::numeric_limits<std::int64_t>::max());
}

TEST(Reading, KeepsAnIntWithinAnInt) {
  struct Narrow {
    int value = 0;
  } narrow;
  const TemporaryFile file(R"({"value": 2147483648})");
  const Describe describe = [&](Fields& fields) { fields.integer("value", narrow.value, {}, ""); };
  EXPECT_THAT(error_of([&] { load_file(file.path(), describe); }),
              HasSubstr("a whole number from -2147483648 to 2147483647"));
}

TEST(Reading, RefusesValuesOutOfRangeAndTakesBothEnds) {
  EXPECT_THAT(error_of_reading(R"({"max_speed": 10.5})"),
              HasSubstr("example.json: /max_speed is 10.5; allowed: a number from 0 to 10"));
  EXPECT_THAT(error_of_reading(R"({"max_speed": -0.001})"), HasSubstr("a number from 0 to 10"));
  EXPECT_THAT(error_of_reading(R"({"beams": 0})"), HasSubstr("a whole number from 1 to 10000"));
  EXPECT_THAT(error_of_reading(R"({"beams": 10001})"), HasSubstr("/beams is 10001"));
  EXPECT_EQ(error_of_reading(R"({"max_speed": 0, "beams": 1})"), "");
  EXPECT_EQ(error_of_reading(R"({"max_speed": 10, "beams": 10000})"), "");
}

TEST(Reading, RefusesEveryWrongType) {
  EXPECT_THAT(error_of_reading(R"({"max_speed": "fast"})"),
              HasSubstr("/max_speed is \"fast\"; allowed: a number"));
  EXPECT_THAT(error_of_reading(R"({"max_speed": true})"), HasSubstr("/max_speed is true"));
  EXPECT_THAT(error_of_reading(R"({"max_speed": null})"), HasSubstr("/max_speed is null"));
  EXPECT_THAT(error_of_reading(R"({"beams": "12"})"), HasSubstr("/beams is \"12\""));
  EXPECT_THAT(error_of_reading(R"({"enabled": 1})"), HasSubstr("allowed: true or false"));
  EXPECT_THAT(error_of_reading(R"({"source": 1})"), HasSubstr("allowed: text in quotes"));
  EXPECT_THAT(error_of_reading(R"({"method": 1})"), HasSubstr("one of \"fast\", \"thorough\""));
  EXPECT_THAT(error_of_reading(R"({"robot": []})"), HasSubstr("/robot is []; allowed: a group"));
  EXPECT_THAT(error_of_reading(R"({"tour": {}})"), HasSubstr("/tour is {}; allowed: a list"));
  EXPECT_THAT(error_of_reading(R"({"tour": [{}, 5]})"), HasSubstr("/tour/1 is 5"));
  EXPECT_THAT(error_of_reading("[]"), HasSubstr("example.json: (the whole) is []"));
}

TEST(Reading, NamesTheNearestWordOfAChoice) {
  EXPECT_THAT(error_of_reading(R"({"method": "thorugh"})"),
              AllOf(HasSubstr("/method is \"thorugh\""), HasSubstr("did you mean \"thorough\"?")));
}

TEST(Reading, NamesTheNearestKeyOfAnUnknownOne) {
  EXPECT_THAT(
      error_of_reading(R"({"max_sped": 1})"),
      AllOf(HasSubstr("example.json: /max_sped is 1: unknown key"),
            HasSubstr("did you mean \"max_speed\"?"), HasSubstr("Allowed: max_speed, big")));
  EXPECT_THAT(error_of_reading(R"({"robot": {"limits": {"trun_rate": 1}}})"),
              AllOf(HasSubstr("/robot/limits/trun_rate"), HasSubstr("\"turn_rate\"")));
  EXPECT_THAT(error_of_reading(R"({"tour": [{}, {"z": 1}]})"), HasSubstr("/tour/1/z"));
}

TEST(Reading, AllowsNoKeyWhereNoneIsDescribed) {
  const TemporaryFile file(R"({"a": 1})");
  EXPECT_THAT(error_of([&] { load_file(file.path(), [](Fields&) {}); }),
              HasSubstr("allowed: none here"));
}

TEST(Reading, IgnoresCommentsThatAreText) {
  EXPECT_EQ(error_of_reading(R"({"_comment": "why", "tour": [{"_comment": "door"}],
                                 "robot": {"_comment": "PICO"}})"),
            "");
  EXPECT_THAT(error_of_reading(R"({"_comment": 1})"), HasSubstr("/_comment is 1"));
}

TEST(Reading, CutsLongValuesAndKeysInErrors) {
  EXPECT_LT(error_of_reading(R"({"max_speed": ")" + std::string(100'000, 'x') + "\"}").size(),
            400U);
  EXPECT_LT(error_of_reading("{\"" + std::string(100'000, 'x') + "\": 1}").size(), 500U);
}

TEST(Reading, ChecksWhatHoldsBetweenValues) {
  EXPECT_THAT(
      error_of_reading(R"({"robot": {"laser": {"valid_min": 5, "valid_max": 4}}})"),
      AllOf(HasSubstr("example.json: /robot/laser/valid_min"), HasSubstr("less than valid_max")));
}

}  // namespace
}  // namespace perceptor::config
