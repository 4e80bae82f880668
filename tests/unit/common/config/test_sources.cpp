#include <gmock/gmock.h>

#include "tests/unit/common/config/example.hpp"
#include "tests/unit/common/config/temporary_file.hpp"

namespace perceptor::config {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::string error_of_setting(const std::string& assignment, Example& example) {
  return error_of([&] { load({{}, {}, {assignment}}, bind(example)); });
}

std::string error_of_setting(const std::string& assignment) {
  Example example;
  example.tour.resize(2);
  return error_of_setting(assignment, example);
}

TEST(Sources, NoneLeavesTheDefaults) {
  Example example;
  load({}, bind(example));
  EXPECT_EQ(example.max_speed, 2.0);
}

TEST(Sources, OwnFileOverridesTheRobotFileAndTheCommandLineBoth) {
  const TemporaryFile robot(R"({"limits": {"speed": 0.1, "turn_rate": 0.2, "acceleration": 0.3}})");
  const TemporaryFile own(R"({"robot": {"limits": {"turn_rate": 0.4, "acceleration": 0.5}}})");
  Example example;
  load({own.path(), robot.path(), {"robot.limits.acceleration=0.6"}}, bind(example));
  EXPECT_EQ(example.robot.limits.speed, 0.1);
  EXPECT_EQ(example.robot.limits.turn_rate, 0.4);
  EXPECT_EQ(example.robot.limits.acceleration, 0.6);
}

TEST(Sources, NamesTheRobotFileInItsErrors) {
  const TemporaryFile robot(R"({"limits": {"sped": 0.1}})", "robot.json");
  Example example;
  EXPECT_THAT(error_of([&] {
                load({{}, robot.path(), {}}, bind(example));
              }),
              AllOf(HasSubstr("robot.json: /limits/sped"), HasSubstr("\"speed\"")));
}

TEST(Sources, LeavesTheRobotFileUnreadWhereNobodyWantsIt) {
  WayPoint point;
  EXPECT_NO_THROW(load({{}, "no/such/robot.json", {}}, bind(point)));
  Example example;
  EXPECT_THROW(load({{}, "no/such/robot.json", {}}, bind(example)), Error);
}

TEST(Sources, ChecksWhatHoldsBetweenValuesOnlyWhenAllAreRead) {
  const TemporaryFile robot(R"({"laser": {"valid_min": 50}})", "robot.json");
  Example example;
  load({{}, robot.path(), {"robot.laser.valid_max=60"}}, bind(example));
  EXPECT_EQ(example.robot.laser.valid_min, 50.0);
  EXPECT_THAT(error_of([&] {
                load({{}, robot.path(), {"robot.laser.valid_max=40"}}, bind(example));
              }),
              HasSubstr("configuration: /robot/laser/valid_min"));
}

TEST(Overrides, SetEveryKindOfField) {
  Example example;
  example.tour.resize(2);
  load({{},
        {},
        {"max_speed=3", "big=-5", "beams=99", "enabled=false", "source=log:my file",
         "method=thorough", "robot.limits.speed=0.7", "tour.1.x=1.5", "tour.0.word=\"12\""}},
       bind(example));
  EXPECT_EQ(example.max_speed, 3.0);
  EXPECT_EQ(example.big, -5);
  EXPECT_EQ(example.beams, 99);
  EXPECT_FALSE(example.enabled);
  EXPECT_EQ(example.source, "log:my file");
  EXPECT_EQ(example.method, Method::thorough);
  EXPECT_EQ(example.robot.limits.speed, 0.7);
  EXPECT_EQ(example.tour[1].x, 1.5);
  EXPECT_EQ(example.tour[0].word, "12");
}

TEST(Overrides, LaterOnesWin) {
  Example example;
  load({{}, {}, {"beams=5", "beams=6"}}, bind(example));
  EXPECT_EQ(example.beams, 6);
}

TEST(Overrides, KeepTheirNeighbours) {
  Example example;
  example.tour = {{1.0, 2.0, "a"}};
  load({{}, {}, {"tour.0.x=5", "robot.limits={\"speed\": 0.7}", "tour.0={\"word\": \"b\"}"}},
       bind(example));
  EXPECT_EQ(example.tour[0].x, 5.0);
  EXPECT_EQ(example.tour[0].y, 2.0);
  EXPECT_EQ(example.tour[0].word, "b");
  EXPECT_EQ(example.robot.limits.turn_rate, 1.2);
}

TEST(Overrides, ReplaceAWholeList) {
  Example example;
  load({{}, {}, {R"(tour=[{"x": 1}, {"x": 2}, {"x": 3}])", "tour.2.x=4"}}, bind(example));
  ASSERT_EQ(example.tour.size(), 3U);
  EXPECT_EQ(example.tour[2].x, 4.0);
}

TEST(Overrides, TextMayBeEmptyAndHoldAnEqualsSign) {
  Example example;
  load({{}, {}, {"source=a=b"}}, bind(example));
  EXPECT_EQ(example.source, "a=b");
  load({{}, {}, {"source="}}, bind(example));
  EXPECT_EQ(example.source, "");
}

TEST(Overrides, ErrorsSayWhatWasWritten) {
  EXPECT_THAT(error_of_setting("max_speed=11"),
              HasSubstr("--set max_speed=11: /max_speed is 11; allowed: a number from 0 to 10"));
  EXPECT_THAT(error_of_setting("beams=1.0"), HasSubstr("without a fraction"));
  EXPECT_THAT(error_of_setting("max_speed=fast"), HasSubstr("/max_speed is \"fast\""));
  EXPECT_THAT(error_of_setting("max_speed=1e999"), HasSubstr("/max_speed is \"1e999\""));
  EXPECT_THAT(error_of_setting("max_speed=nan"), HasSubstr("/max_speed is \"nan\""));
  EXPECT_THAT(error_of_setting("tour.1.x=left"), HasSubstr("/tour/1/x is \"left\""));
  EXPECT_THAT(error_of_setting("source=12"), HasSubstr("allowed: text in quotes"));
}

TEST(Overrides, UnknownKeysNameTheNearestAtTheirLevel) {
  EXPECT_THAT(error_of_setting("robot.limits.sped=0.7"),
              AllOf(HasSubstr("--set robot.limits.sped=0.7: /robot/limits/sped"),
                    HasSubstr("did you mean \"speed\"?")));
  EXPECT_THAT(error_of_setting("robto.limits.speed=0.7"), HasSubstr("\"robot\""));
  EXPECT_THAT(error_of_setting("tour.0.z=1"), HasSubstr("/tour/0/z"));
  EXPECT_THAT(error_of_setting("robot={\"limit\": {}}"), HasSubstr("\"limits\""));
  EXPECT_THAT(error_of_setting("_comment=why"), HasSubstr("unknown key"));
}

TEST(Overrides, RefusePathsThatLeadNowhere) {
  EXPECT_THAT(error_of_setting("max_speed.x=1"), HasSubstr("/max_speed is a single value"));
  EXPECT_THAT(error_of_setting("robot=1"), HasSubstr("/robot is 1; allowed: a group"));
  for (const char* index : {"2", "-1", "x", "", "1x", "99999999999999999999"})
    EXPECT_THAT(error_of_setting(std::string("tour.") + index + ".x=1"),
                HasSubstr("an index below 2"))
        << index;
}

TEST(Overrides, RefuseWhatIsNoAssignment) {
  for (const char* text : {"max_speed", "=1", ""})
    EXPECT_THAT(error_of_setting(text), HasSubstr("allowed: key=value")) << text;
}

TEST(Overrides, RefuseDuplicateKeysAndTowersInTheirValue) {
  EXPECT_THAT(error_of_setting(R"(robot.limits={"speed": 1, "speed": 2})"), HasSubstr("twice"));
  EXPECT_THAT(error_of_setting("tour=" + std::string(100, '[') + std::string(100, ']')),
              HasSubstr("nests too deep"));
}

TEST(Overrides, BytesThatAreNoUtf8StayTextAndMakeNoTrouble) {
  EXPECT_THAT(error_of_setting("max_speed=\xff"), HasSubstr("/max_speed is"));
  Example example;
  EXPECT_EQ(error_of_setting("source=\xff", example), "");
  EXPECT_EQ(example.source, "\xff");
  EXPECT_NO_THROW(print(bind(example)));
  EXPECT_NO_THROW(explain(bind(example)));
}

}  // namespace
}  // namespace perceptor::config
