#include <gmock/gmock.h>

#include "common/config/json_file.hpp"
#include "tests/unit/common/config/example.hpp"
#include "tests/unit/common/config/temporary_file.hpp"

namespace perceptor::config {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

std::string parse_error_of(const std::string& text) {
  return error_of([&] { parse_json(text, "a.json"); });
}

TEST(JsonFile, ReadsEveryKindOfValue) {
  const TemporaryFile file(R"( {"a": [1, -2, 2.5, 18446744073709551615, "text", true, null],
                                "b": {"c": {}, "d": []}} )");
  const nlohmann::json value = read_json(file.path());
  EXPECT_EQ(value["a"].dump(), R"([1,-2,2.5,18446744073709551615,"text",true,null])");
  EXPECT_EQ(value["b"].dump(), R"({"c":{},"d":[]})");
}

TEST(JsonFile, NamesAFileThatIsMissing) {
  EXPECT_THAT(error_of([] { read_json("no/such.json"); }),
              AllOf(HasSubstr("no/such.json"), HasSubstr("No such file")));
}

TEST(JsonFile, RefusesADirectory) {
  EXPECT_THAT(error_of([] { read_json(testing::TempDir()); }), HasSubstr("directory"));
}

TEST(JsonFile, RefusesAnEmptyFile) {
  const TemporaryFile file("");
  EXPECT_THAT(error_of([&] { read_json(file.path()); }),
              AllOf(HasSubstr(file.path().string()), HasSubstr("line 1"), HasSubstr("no JSON")));
}

TEST(JsonFile, ReadsUpToTheLimitAndNoFurther) {
  const std::string blanks(kMaxFileSize - 2, ' ');
  const TemporaryFile fits("[]" + blanks);
  EXPECT_TRUE(read_json(fits.path()).is_array());
  const TemporaryFile too_large("[]" + blanks + " ");
  EXPECT_THAT(error_of([&] { read_json(too_large.path()); }),
              AllOf(HasSubstr("too large"), HasSubstr("4000000 bytes")));
}

TEST(JsonFile, RefusesFiftyMegabytesWithoutParsingThem) {
  const TemporaryFile file(std::string(50'000'000, '['));
  EXPECT_THAT(error_of([&] { read_json(file.path()); }), HasSubstr("too large"));
}

TEST(JsonFile, ReadsALargeListOfSmallObjectsInLinearTime) {
  std::string text = "[{}";
  while (text.size() < kMaxFileSize / 10) text += ",{}";
  EXPECT_GT(parse_json(text + "]", "a.json").size(), 100'000U);
}

TEST(JsonFile, BoundsNestingBeforeParsing) {
  const auto nested = [](int depth) {
    return std::string(static_cast<std::size_t>(depth), '[') +
           std::string(static_cast<std::size_t>(depth), ']');
  };
  EXPECT_NO_THROW(parse_json(nested(kMaxNesting), "a.json"));
  EXPECT_THAT(parse_error_of("\n\n" + nested(kMaxNesting + 1)),
              AllOf(HasSubstr("a.json"), HasSubstr("line 3"), HasSubstr("nests too deep"),
                    HasSubstr("32 levels")));
  EXPECT_THAT(parse_error_of(std::string(1'000'000, '{')), HasSubstr("nests too deep"));
}

TEST(JsonFile, CountsNoBracketsInsideOfText) {
  EXPECT_NO_THROW(parse_json("[\"\\\"" + std::string(100, '[') + "\"]", "a.json"));
}

TEST(JsonFile, TellsTheLineOfASyntaxError) {
  EXPECT_THAT(parse_error_of("{\n  \"a\": 1,\n  \"b\" 2\n}"),
              AllOf(HasSubstr("a.json: line 3: no JSON: "), Not(HasSubstr("json.exception"))));
}

TEST(JsonFile, RefusesWhatFollowsTheValue) {
  EXPECT_THAT(parse_error_of("{} {}"), HasSubstr("no JSON"));
}

TEST(JsonFile, RefusesTextThatIsNoUtf8) {
  EXPECT_THAT(parse_error_of("[\"\xff\"]"), HasSubstr("no JSON"));
}

TEST(JsonFile, RefusesDuplicateKeysAnywhere) {
  EXPECT_THAT(parse_error_of(R"({"a": 1, "a": 1})"),
              AllOf(HasSubstr("a.json: /a "), HasSubstr("twice")));
  EXPECT_THAT(parse_error_of(R"({"a": [1, {"b": {}}, {"c": [], "b/~": 1, "b/~": 2}]})"),
              HasSubstr("/a/2/b~1~0 "));
}

TEST(JsonFile, TakesTheSameKeyInDifferentObjects) {
  EXPECT_NO_THROW(parse_json(R"({"a": {"a": [{"a": 1}, {"a": 1}]}})", "a.json"));
}

TEST(JsonFile, RefusesNumbersBeyondADouble) {
  EXPECT_THAT(parse_error_of(R"({"a": [0, 1e999]})"),
              AllOf(HasSubstr("a.json: /a/1 "), HasSubstr("1e999")));
  EXPECT_THAT(parse_error_of(R"({"a": {"b": -1e999}})"), HasSubstr("/a/b "));
  EXPECT_THAT(parse_error_of("1e999"), HasSubstr("1e999"));
}

TEST(JsonFile, KnowsNoNanAndNoInfinity) {
  EXPECT_THAT(parse_error_of("[NaN]"), HasSubstr("no JSON"));
  EXPECT_THAT(parse_error_of("[Infinity]"), HasSubstr("no JSON"));
}

TEST(JsonFile, CutsLongErrors) {
  EXPECT_LT(parse_error_of("\"" + std::string(100'000, 'x')).size(), 300U);
  EXPECT_LT(parse_error_of("[1e" + std::string(100'000, '9') + "]").size(), 300U);
}

}  // namespace
}  // namespace perceptor::config
