#include <gmock/gmock.h>

#include "common/config/fields.hpp"
#include "common/floorplan/floorplan.hpp"
#include "tests/unit/common/config/temporary_file.hpp"

namespace perceptor {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

constexpr const char* kSquare =
    R"("points": [{"x": 0, "y": 0}, {"x": 4, "y": 0.0}, {"x": 4, "y": -3.5}, {"x": 0, "y": 0}])";

Floorplan read(const std::string& text) {
  const TemporaryFile file(text, "plan.json");
  return read_floorplan(file.path());
}

/// Of a map with the points above and what else is given.
std::string error_of(const std::string& rest, const std::string& points = kSquare) {
  try {
    read("{" + points + (rest.empty() ? "" : ", ") + rest + "}");
  } catch (const config::Error& error) {
    return error.what();
  }
  return "";
}

TEST(Floorplan, ReadsPointsWallsCabinetsDoorsAndStartArea) {
  const Floorplan plan = read(R"({"_comment": "any",
      "points": [{"x": 0, "y": 0, "_comment": 17}, {"x": 4.5, "y": 0}, {"x": 4.5, "y": -3},
                 {"y": 1, "x": -1}],
      "walls": [[0, 1], [2, 1]],
      "cabinets": [[[1, 2], [2, 3], [3, 1]]],
      "doors": [[[2, 3]], [[0, 2], [2, 3]]],
      "start_area": [[[0, 1], [1, 2], [2, 0]]]})");
  ASSERT_EQ(plan.points.size(), 4U);
  EXPECT_EQ(plan.points[2], Vector2(4.5, -3.0));
  EXPECT_EQ(plan.points[3], Vector2(-1.0, 1.0));
  EXPECT_THAT(plan.walls, ElementsAre(Floorplan::Edge{0, 1}, Floorplan::Edge{2, 1}));
  EXPECT_EQ(plan.segment(plan.walls[1]).a, Vector2(4.5, -3.0));
  EXPECT_EQ(plan.segment(plan.walls[1]).b, Vector2(4.5, 0.0));
  ASSERT_EQ(plan.cabinets.size(), 1U);
  EXPECT_EQ(plan.cabinets[0].size(), 3U);
  ASSERT_EQ(plan.doors.size(), 2U);
  EXPECT_EQ(plan.doors[1].size(), 2U);
  EXPECT_EQ(plan.start_area.size(), 1U);
  EXPECT_THAT(plan.ignored, IsEmpty());
}

TEST(Floorplan, NeedsNoCabinetsDoorsOrStartArea) {
  const Floorplan plan = read("{" + std::string(kSquare) + R"(, "walls": [[0, 1]], "doors": []})");
  EXPECT_THAT(plan.cabinets, IsEmpty());
  EXPECT_THAT(plan.doors, IsEmpty());
  EXPECT_THAT(plan.start_area, IsEmpty());
}

TEST(Floorplan, NamesTheKeysThatItIgnores) {
  const Floorplan plan = read(R"({"points": [{"x": 0, "y": 0, "a": 0.5}, {"x": 1, "y": 0}],
                                  "walls": [[0, 1]], "nodes": [{"x": 1}], "node/links": {}})");
  EXPECT_THAT(plan.ignored, UnorderedElementsAre("/points/0/a", "/nodes", "/node~1links"));
}

TEST(Floorplan, RefusesIndicesThatAreNone) {
  EXPECT_THAT(error_of(R"("walls": [[0, 1], [1, 4]])"),
              AllOf(HasSubstr("plan.json: /walls/1/1 is 4"), HasSubstr("from 0 to 3")));
  EXPECT_THAT(error_of(R"("walls": [[-1, 1]])"), HasSubstr("/walls/0/0 is -1"));
  EXPECT_THAT(error_of(R"("walls": [["0", 1]])"), HasSubstr("/walls/0/0 is \"0\""));
  EXPECT_THAT(error_of(R"("walls": [[0, 1.0]])"),
              AllOf(HasSubstr("/walls/0/1 is 1.0"), HasSubstr("without a fraction")));
  EXPECT_THAT(error_of(R"("walls": [[0, 4294967297]])"), HasSubstr("is 4294967297"));
}

TEST(Floorplan, RefusesWallsThatAreNoPairOrHaveNoLength) {
  EXPECT_THAT(error_of(R"("walls": [[0, 1, 2]])"), HasSubstr("/walls/0 is [0,1,2]"));
  EXPECT_THAT(error_of(R"("walls": [[0]])"), HasSubstr("/walls/0 is [0]"));
  EXPECT_THAT(error_of(R"("walls": [5])"), HasSubstr("/walls/0 is 5"));
  EXPECT_THAT(error_of(R"("walls": [[1, 1]])"),
              AllOf(HasSubstr("/walls/0 is [1,1]"), HasSubstr("two points that lie apart")));
  EXPECT_THAT(error_of(R"("walls": [[0, 3]])"), HasSubstr("two points that lie apart"));
}

TEST(Floorplan, RefusesAMapWithoutWallsOrPoints) {
  EXPECT_THAT(error_of(""), HasSubstr("plan.json: /walls is missing"));
  EXPECT_THAT(error_of(R"("walls": [])"), HasSubstr("at least one wall"));
  EXPECT_THAT(error_of(R"("walls": {})"), HasSubstr("/walls is {}"));
  EXPECT_THAT(error_of(R"("walls": [[0, 1]])", R"("_comment": 0)"),
              HasSubstr("/points is missing"));
  EXPECT_THAT(error_of(R"("walls": [[0, 1]])", R"("points": [])"), HasSubstr("at least one point"));
}

TEST(Floorplan, RefusesPointsThatAreNone) {
  const auto with_point = [](const std::string& point) {
    return error_of(R"("walls": [[0, 1]])", R"("points": [{"x": 0, "y": 0}, )" + point + "]");
  };
  EXPECT_THAT(with_point(R"({"y": 1})"),
              AllOf(HasSubstr("/points/1 is {\"y\":1}"), HasSubstr("no x")));
  EXPECT_THAT(with_point(R"({"x": 1})"), HasSubstr("no y"));
  EXPECT_THAT(with_point(R"({"x": "1", "y": 0})"), HasSubstr("/points/1/x is \"1\""));
  EXPECT_THAT(with_point(R"({"x": 1, "y": null})"), HasSubstr("/points/1/y is null"));
  EXPECT_THAT(with_point(R"({"x": 1e5, "y": 0})"), HasSubstr("from -10000 to 10000"));
  EXPECT_THAT(with_point(R"({"x": 1e999, "y": 0})"), HasSubstr("/points/1/x is 1e999"));
  EXPECT_THAT(with_point("[1, 0]"), HasSubstr("/points/1 is [1,0]"));
}

TEST(Floorplan, RefusesOutlinesThatAreNone) {
  EXPECT_THAT(error_of(R"("walls": [[0, 1]], "cabinets": {})"), HasSubstr("/cabinets is {}"));
  EXPECT_THAT(error_of(R"("walls": [[0, 1]], "cabinets": [[]])"),
              AllOf(HasSubstr("/cabinets/0 is []"), HasSubstr("at least one edge")));
  EXPECT_THAT(error_of(R"("walls": [[0, 1]], "cabinets": [[[0, 1], [1, 9]]])"),
              HasSubstr("/cabinets/0/1/1 is 9"));
  EXPECT_THAT(error_of(R"("walls": [[0, 1]], "doors": [[0, 1]])"), HasSubstr("/doors/0/0 is 0"));
  EXPECT_THAT(error_of(R"("walls": [[0, 1]], "start_area": [[[0, 0]]])"),
              HasSubstr("/start_area/0/0 is [0,0]"));
}

TEST(Floorplan, RefusesFilesThatAreNone) {
  EXPECT_THROW(read_floorplan("no/such/map.json"), config::Error);
  EXPECT_THROW(read("[]"), config::Error);
  EXPECT_THROW(read(R"({"walls": [], "walls": []})"), config::Error);
  EXPECT_THROW(read(std::string(1000, '[')), config::Error);
  EXPECT_THROW(read(std::string(5'000'000, ' ')), config::Error);
}

}  // namespace
}  // namespace perceptor
