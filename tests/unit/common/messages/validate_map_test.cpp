#include <limits>
#include <ostream>
#include <string>

#include <gtest/gtest.h>

#include "common/messages/convert.hpp"
#include "tests/support/message_samples.hpp"

namespace perceptor::messages {
namespace {

using pico::map_t;

struct MapCase {
  const char* name;
  void (*edit)(map_t&);
  const char* reason;

  friend void PrintTo(const MapCase& map, std::ostream* out) { *out << map.name; }
};

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

class ValidateMap : public testing::TestWithParam<MapCase> {};

TEST_P(ValidateMap, GivesTheReason) {
  auto map = sample<map_t>();
  ASSERT_EQ(validate(map), "");
  GetParam().edit(map);
  EXPECT_EQ(validate(map), GetParam().reason);
}

std::string name_of(const testing::TestParamInfo<MapCase>& suite) { return suite.param.name; }

const MapCase kHeadCases[] = {
    {"FrameOther", [](map_t& m) { m.frame = "robt"; }, "unknown frame"},
    {"FrameEmpty", [](map_t& m) { m.frame.clear(); }, "unknown frame"},
    {"FrameWorld", [](map_t& m) { m.frame = "world"; }, ""},
    {"PartNegative", [](map_t& m) { m.part = -1; }, "part out of range"},
    {"PartBeyond", [](map_t& m) { m.part = 1; }, "part out of range"},
    {"PartsNone", [](map_t& m) { m.parts = 0; }, "part out of range"},
    {"PartsTooMany", [](map_t& m) { m.parts = 1001; }, "too many parts"},
    {"PartLast", [](map_t& m) { m.part = 1, m.parts = 2; }, ""},
    {"ZeroUtime", [](map_t& m) { m.zero_utime = -1; }, "zero_utime out of range"},
    {"ZeroPose", [](map_t& m) { m.robot_in_zero.y = kNan; }, "robot_in_zero out of range"},
    {"LocalPose", [](map_t& m) { m.robot_in_local.a = kInfinity; }, "robot_in_local out of range"},
    {"CovarianceUnknown", [](map_t& m) { m.robot_in_local_covariance[0] = -1.0; }, ""},
    {"CovarianceNan", [](map_t& m) { m.robot_in_local_covariance[4] = kNan; },
     "robot_in_local_covariance out of range"},
    {"CovarianceNegative", [](map_t& m) { m.robot_in_local_covariance[8] = -1e-3; },
     "robot_in_local_covariance out of range"},
    {"CovarianceLopsided", [](map_t& m) { m.robot_in_local_covariance[1] = 1e-4; },
     "robot_in_local_covariance out of range"},
    {"CovarianceTooDependent",
     [](map_t& m) { m.robot_in_local_covariance[5] = m.robot_in_local_covariance[7] = 2e-3; },
     "robot_in_local_covariance out of range"},
    {"CovarianceRounded", [](map_t& m) { m.robot_in_local_covariance[1] = 1e-18; }, ""},
    {"Unobservable", [](map_t& m) { m.unobservable_direction = kNan; },
     "unobservable_direction out of range"},
    {"PointCount", [](map_t& m) { ++m.num_points; }, "count differs from the array"},
    {"ObjectCount", [](map_t& m) { m.num_objects = -1; }, "count differs from the array"},
    {"NothingInIt", [](map_t& m) { set_map(m, Map{}); }, ""},
    {"ManyPoints",
     [](map_t& m) {
       m.points.resize(1001);
       m.num_points = 1001;
     },
     "too many points"},
    {"ManyObjects",
     [](map_t& m) {
       m.objects.resize(1001);
       m.num_objects = 1001;
     },
     "too many objects"}};

INSTANTIATE_TEST_SUITE_P(Head, ValidateMap, testing::ValuesIn(kHeadCases), name_of);

const MapCase kPointCases[] = {
    {"XNan", [](map_t& m) { m.points[0].x = kNan; }, "location of a point out of range"},
    {"YInfinite", [](map_t& m) { m.points[0].y = -kInfinity; }, "location of a point out of range"},
    {"XHuge", [](map_t& m) { m.points[0].x = 1e7; }, "location of a point out of range"},
    {"CovarianceNan", [](map_t& m) { m.points[1].covariance[0] = kNan; },
     "covariance of a point out of range"},
    {"CovarianceUnknown", [](map_t& m) { m.points[1].covariance[0] = -1.0; }, ""},
    {"CovarianceOfALine",
     [](map_t& m) {
       for (double& entry : m.points[1].covariance) entry = 1e-4;
     },
     ""},
    {"CovarianceTooDependent", [](map_t& m) { m.points[1].covariance[1] = -2e-4; },
     "covariance of a point out of range"},
    {"CovarianceHuge", [](map_t& m) { m.points[1].covariance[2] = 1e300; },
     "covariance of a point out of range"},
    {"PropertyBeyond", [](map_t& m) { m.points[0].property = 4; }, "unknown kind of point"},
    {"PropertyNegative", [](map_t& m) { m.points[0].property = -1; }, "unknown kind of point"},
    {"MethodBeyond", [](map_t& m) { m.points[0].method = 5; }, "unknown kind of point"},
    {"RadiusNegative", [](map_t& m) { m.points[0].radius = -0.1; },
     "radius of a point out of range"},
    {"WeightInfinite", [](map_t& m) { m.points[0].weight = kInfinity; },
     "weight of a point out of range"},
    {"ConnectedBeyond", [](map_t& m) { m.points[0].connected_point = 5; },
     "reference of a point out of range"},
    {"ConnectedNegative", [](map_t& m) { m.points[0].connected_point = -2; },
     "reference of a point out of range"},
    {"ProjectionBeyond", [](map_t& m) { m.points[0].projection_point = 1'000'000; },
     "reference of a point out of range"},
    {"ParentBeyond", [](map_t& m) { m.points[0].parents[0] = 2; },
     "reference of a point out of range"},
    {"ParentNone", [](map_t& m) { m.points[0].parents[0] = -1; },
     "reference of a point out of range"},
    {"ParentCount", [](map_t& m) { m.points[0].num_parents = 0; }, "count differs from the array"},
    {"ParentOther", [](map_t& m) { m.points[0].parents[0] = 1; }, "points and objects disagree"},
    {"ParentMissing",
     [](map_t& m) {
       m.points[0].parents.clear();
       m.points[0].num_parents = 0;
     },
     "points and objects disagree"},
    {"ConnectedOneSided", [](map_t& m) { m.points[0].connected_point = 1; },
     "one-sided connection of points"},
    {"ConnectedToItself", [](map_t& m) { m.points[0].connected_point = 0; },
     "one-sided connection of points"},
    {"ProjectedOnItself", [](map_t& m) { m.points[0].projection_point = 0; },
     "point projected on itself"}};

INSTANTIATE_TEST_SUITE_P(Point, ValidateMap, testing::ValuesIn(kPointCases), name_of);

const MapCase kObjectCases[] = {
    {"NameLong", [](map_t& m) { m.objects[0].name = "this is sixteen!"; },
     "name of an object too long"},
    {"NameFifteen", [](map_t& m) { m.objects[0].name = "exactly fifteen"; }, ""},
    {"TypeBeyond", [](map_t& m) { m.objects[0].type = 11; }, "unknown kind of object"},
    {"TypeNegative", [](map_t& m) { m.objects[0].type = -1; }, "unknown kind of object"},
    {"DrawType", [](map_t& m) { m.objects[0].draw_type = 2; }, "unknown kind of object"},
    {"Connection", [](map_t& m) { m.objects[0].connection = 2; }, "unknown kind of object"},
    {"Colour", [](map_t& m) { m.objects[0].colour = 0x1000000; }, "colour out of range"},
    {"ColourNegative", [](map_t& m) { m.objects[0].colour = -1; }, "colour out of range"},
    {"FreeSide", [](map_t& m) { m.objects[0].free_side = 2; }, "free side out of range"},
    {"Support", [](map_t& m) { m.objects[0].support = -1; }, "certainty of an object out of range"},
    {"Weight", [](map_t& m) { m.objects[0].weight = kNan; }, "certainty of an object out of range"},
    {"Confidence", [](map_t& m) { m.objects[0].confidence = 1.1; },
     "certainty of an object out of range"},
    {"Covariance", [](map_t& m) { m.objects[0].line_covariance[2] = -1.0; },
     "covariance of an object out of range"},
    {"FirstSeen", [](map_t& m) { m.objects[0].first_seen = -1; },
     "utime of an object out of range"},
    {"LastSeen", [](map_t& m) { m.objects[0].last_seen = -1; }, "utime of an object out of range"},
    {"NoPoints",
     [](map_t& m) {
       m.objects[0].type = pico::map_object_t::CABINET;
       m.objects[0].points.clear();
       m.objects[0].num_points = 0;
     },
     "object without points"},
    {"WallOfOnePoint",
     [](map_t& m) {
       m.objects[0].points.pop_back();
       m.objects[0].num_points = 1;
     },
     "wall or door without two points"},
    {"PointCount", [](map_t& m) { m.objects[0].num_points = 3; }, "count differs from the array"},
    {"PointBeyond", [](map_t& m) { m.objects[0].points[1] = 5; },
     "reference of an object out of range"},
    {"PointNone", [](map_t& m) { m.objects[0].points[1] = -1; },
     "reference of an object out of range"},
    {"PointOther", [](map_t& m) { m.objects[0].points[1] = 4; }, "points and objects disagree"}};

INSTANTIATE_TEST_SUITE_P(Object, ValidateMap, testing::ValuesIn(kObjectCases), name_of);

TEST(ValidateMapObjects, ACabinetHasAnyNumberOfPoints) {
  auto message = sample<map_t>();
  Map map = to_model(message);
  Object cabinet;
  cabinet.type = ObjectType::cabinet;
  cabinet.connection = Connection::closed;
  for (int corner = 0; corner < 4; ++corner) {
    cabinet.points.push_back(add_point(map, Vector2(corner, 8.0)));
    map.points.back().parents = {2};
  }
  map.objects.push_back(cabinet);
  set_map(message, map);
  EXPECT_EQ(validate(message), "");
}

}  // namespace
}  // namespace perceptor::messages
