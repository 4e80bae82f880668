#include <cmath>
#include <limits>

#include <gmock/gmock.h>

#include "tests/unit/common/config/example.hpp"
#include "tests/unit/common/config/temporary_file.hpp"

namespace perceptor::config {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(Print, FollowsTheOrderOfDescription) {
  Example example;
  example.tour = {{1.0, 2.5, "a \"b\""}};
  const std::string text = print(bind(example));
  EXPECT_THAT(text, HasSubstr("{\n  \"max_speed\": 2.0,\n  \"big\": 7,\n  \"beams\": 1000,\n"
                              "  \"enabled\": true,\n  \"source\": \"sim\",\n"
                              "  \"method\": \"fast\",\n  \"tour\": [\n"
                              "    {\"x\": 1.0, \"y\": 2.5, \"word\": \"a \\\"b\\\"\"}\n  ],\n"
                              "  \"robot\": {\n    \"footprint\": [\n"));
}

TEST(Print, ReadsBackToTheSameValues) {
  Example example;
  example.max_speed = 0.1 + 0.2;  // not 0.3
  example.big = std::numeric_limits<std::int64_t>::min();
  example.method = Method::thorough;
  example.enabled = false;
  example.source = "log:a \"b\" \\ \n \xc3\xa9";
  example.tour = {
      {1.0 / 3.0, -0.0, ""},
      {std::numeric_limits<double>::max(), std::numeric_limits<double>::denorm_min(), "there"}};
  example.robot.footprint.resize(3);
  example.robot.laser.laser_in_robot = {0.1, -1e-9, 3.14159265358979};

  const TemporaryFile file(print(bind(example)));
  Example again;
  load_file(file.path(), bind(again));
  EXPECT_EQ(again.max_speed, example.max_speed);
  EXPECT_EQ(again.big, example.big);
  EXPECT_EQ(again.method, example.method);
  EXPECT_EQ(again.enabled, example.enabled);
  EXPECT_EQ(again.source, example.source);
  ASSERT_EQ(again.tour.size(), 2U);
  EXPECT_EQ(again.tour[0].x, 1.0 / 3.0);
  EXPECT_TRUE(std::signbit(again.tour[0].y));
  EXPECT_EQ(again.tour[1].x, example.tour[1].x);
  EXPECT_EQ(again.tour[1].y, example.tour[1].y);
  EXPECT_EQ(again.robot.footprint.size(), 3U);
  EXPECT_EQ(again.robot.laser.laser_in_robot, example.robot.laser.laser_in_robot);
  EXPECT_EQ(print(bind(again)), print(bind(example)));
}

TEST(Explain, HasALineForEachKey) {
  Example example;
  const std::string text = explain(bind(example));
  EXPECT_THAT(text, testing::MatchesRegex("(.|\n)*  max_speed +2.0 +\\[m/s\\] faster is a jump "
                                          "\\(a number from 0 to 10\\)\n(.|\n)*"));
  EXPECT_THAT(text, HasSubstr("(one of \"fast\", \"thorough\")"));
  EXPECT_THAT(text, HasSubstr("  robot.limits.speed "));
  EXPECT_THAT(text, HasSubstr("any whole number (a whole number)"));
}

TEST(Explain, ShowsTheKeysOfAListEvenWhereItIsEmpty) {
  Example example;
  const std::string text = explain(bind(example));
  EXPECT_THAT(text, HasSubstr("  tour.N.word "));
  EXPECT_THAT(text, HasSubstr("  robot.footprint.N.x "));
  EXPECT_THAT(text, Not(HasSubstr("tour.1")));
  EXPECT_TRUE(example.tour.empty());
  EXPECT_EQ(example.robot.footprint.size(), 8U);
}

TEST(Explain, NamesBoundsOnOneSide) {
  double value = 1.0;
  std::int64_t count = 1;
  const std::string text = explain([&](Fields& fields) {
    fields.number("a", value, {.min = 0.5}, "");
    fields.number("b", value, {.max = 1e-6}, "");
    fields.integer("c", count, {.min = -3}, "");
  });
  EXPECT_THAT(text, HasSubstr("a number of at least 0.5"));
  EXPECT_THAT(text, HasSubstr("a number of at most 1e-06"));
  EXPECT_THAT(text, HasSubstr("a whole number of at least -3"));
}

}  // namespace
}  // namespace perceptor::config
