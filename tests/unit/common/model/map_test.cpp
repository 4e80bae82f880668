#include "common/model/map.hpp"

#include <numbers>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace perceptor {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

constexpr double pi = std::numbers::pi;

Index add_wall(Map& map, double ax, double ay, double bx, double by) {
  return add_segment(map, {Vector2(ax, ay), Vector2(bx, by)}, ObjectType::wall);
}

/// Two walls that meet in a corner at (4, 0): points 1 and 2.
///
///            3
///            |
///     0 ---- 1,2
Map corner() {
  Map map;
  add_wall(map, 0.0, 0.0, 4.0, 0.0);
  add_wall(map, 4.0, 0.0, 4.0, 3.0);
  connect(map, 1, 2);
  return map;
}

Object cabinet_of(std::vector<Index> points) {
  Object cabinet;
  cabinet.name = "cabinet";
  cabinet.type = ObjectType::cabinet;
  cabinet.points = std::move(points);
  return cabinet;
}

TEST(Map, AnEmptyOneIsSound) {
  Map map;
  EXPECT_EQ(find_broken_reference(map), "");
  remove_objects(map);
  set_objects_old(map);
  EXPECT_TRUE(transform(map, {1.0, 2.0, 3.0}).points.empty());
}

TEST(Map, AnAddedPointIsALoneCorner) {
  Map map;
  EXPECT_EQ(add_point(map, Vector2(1.0, 2.0)), 0);
  EXPECT_EQ(add_point(map, Vector2(3.0, 4.0)), 1);
  EXPECT_EQ(map.points[1].location, Vector2(3.0, 4.0));
  EXPECT_TRUE(map.points[1].parents.empty());
  EXPECT_EQ(map.points[1].property, PointProperty::floating);
  EXPECT_EQ(find_broken_reference(map), "");
}

TEST(Map, AnAddedSegmentOwnsTwoNewPoints) {
  Map map;
  add_point(map, Vector2(9.0, 9.0));
  const Index door =
      add_segment(map, {Vector2(0.0, 0.0), Vector2(1.0, 0.0)}, ObjectType::door, "door 1");
  EXPECT_EQ(door, 0);
  EXPECT_EQ(map.objects[0].name, "door 1");
  EXPECT_EQ(map.objects[0].type, ObjectType::door);
  EXPECT_TRUE(map.objects[0].is_new);
  EXPECT_THAT(map.objects[0].points, ElementsAre(1, 2));
  EXPECT_THAT(map.points[1].parents, ElementsAre(0));
  EXPECT_EQ(segment(map, door).b, Vector2(1.0, 0.0));
  EXPECT_EQ(find_broken_reference(map), "");
}

TEST(Map, ANameThatIsTooLongIsCutBetweenCharacters) {
  Map map;
  add_segment(map, {}, ObjectType::wall, "exactly fifteen");
  add_segment(map, {}, ObjectType::wall, "this is sixteen!");
  add_segment(map, {}, ObjectType::wall, "fourteen bytes\xC3\xA9");
  EXPECT_EQ(map.objects[0].name, "exactly fifteen");
  EXPECT_EQ(map.objects[1].name, "this is sixteen");
  EXPECT_EQ(map.objects[2].name, "fourteen bytes");
}

TEST(Map, AnotherNumberOfPointsIsNotASegment) {
  Map map = corner();
  const std::vector<std::vector<Index>> others = {{}, {0}, {0, 1, 2}};
  const Object& wall = map.objects[0];
  for (const std::vector<Index>& points : others) {
    Map broken = map;
    broken.objects[1] = cabinet_of(points);
    const Object& other = broken.objects[1];
    EXPECT_THROW(segment(broken, 1), NotASegment);
    EXPECT_THROW(set_segment(broken, 1, {}), NotASegment);
    EXPECT_THROW(angle(broken, other), NotASegment);
    EXPECT_THROW(length(broken, other), NotASegment);
    EXPECT_THROW(smallest_relative_angle(broken, wall, other), NotASegment);
    EXPECT_THROW(angle_between(broken, other, wall), NotASegment);
    EXPECT_THROW(average_perpendicular_distance(broken, wall, other), NotASegment);
    EXPECT_THROW(gap_distance(broken, other, wall), NotASegment);
  }
  EXPECT_THAT(NotASegment(cabinet_of({1})).what(),
              testing::StrEq("object 'cabinet' (cabinet) has 1 points where two are needed"));
}

TEST(Map, AnIndexThatPointsAtNothingIsAnError) {
  const Map map = corner();
  EXPECT_THROW(segment(map, 2), std::out_of_range);
  EXPECT_THROW(segment(map, kNone), std::out_of_range);
  EXPECT_THROW(same_parent_object(map, 0, 4), std::out_of_range);
}

TEST(Map, FunctionsOfObjectsAreThoseOfTheirSegments) {
  const Map map = corner();
  const Object& along_x = map.objects[0];
  const Object& along_y = map.objects[1];
  EXPECT_EQ(length(map, along_x), 4.0);
  EXPECT_EQ(angle(map, along_y), 0.5 * pi);
  EXPECT_EQ(smallest_relative_angle(map, along_x, along_y), 0.5 * pi);
  EXPECT_EQ(angle_between(map, along_y, along_x), 1.5 * pi);
  EXPECT_EQ(average_perpendicular_distance(map, along_x, along_y), 1.5);
  EXPECT_EQ(gap_distance(map, along_x, along_y), 0.0);
}

TEST(Map, SetSegmentMovesBothEnds) {
  Map map = corner();
  set_segment(map, 1, {Vector2(5.0, 6.0), Vector2(7.0, 8.0)});
  EXPECT_EQ(map.points[2].location, Vector2(5.0, 6.0));
  EXPECT_EQ(map.points[3].location, Vector2(7.0, 8.0));
  EXPECT_EQ(map.points[1].location, Vector2(4.0, 0.0)) << "the other wall stays";
}

TEST(Map, SameParentObjectIsThatOfThePoints) {
  Map map = corner();
  const Index lone = add_point(map, Vector2(1.0, 1.0));
  EXPECT_TRUE(same_parent_object(map, 0, 1));
  EXPECT_TRUE(same_parent_object(map, 2, 2));
  EXPECT_FALSE(same_parent_object(map, 1, 2)) << "connected, but of different walls";
  EXPECT_FALSE(same_parent_object(map, lone, 0));
  EXPECT_FALSE(same_parent_object(map, lone, lone)) << "a lone corner belongs to nothing";
}

TEST(Connect, MakesTwoPointsACorner) {
  const Map map = corner();
  EXPECT_EQ(map.points[1].connected, 2);
  EXPECT_EQ(map.points[2].connected, 1);
  EXPECT_EQ(map.points[1].property, PointProperty::connected);
  EXPECT_EQ(map.points[2].property, PointProperty::connected);
  EXPECT_EQ(find_broken_reference(map), "");
}

TEST(Connect, LeavesTheFormerPartnersLoose) {
  Map map = corner();
  add_wall(map, 4.0, 0.0, 8.0, 0.0);
  add_wall(map, 4.0, 0.0, 4.0, -3.0);
  connect(map, 4, 6);
  connect(map, 1, 4);
  EXPECT_EQ(map.points[1].connected, 4);
  for (const std::size_t loose : {2U, 6U}) {
    EXPECT_EQ(map.points[loose].connected, kNone);
    EXPECT_EQ(map.points[loose].property, PointProperty::floating);
  }
  EXPECT_EQ(find_broken_reference(map), "");
}

TEST(Connect, TwiceIsOnceAndAPointIsNotConnectedToItself) {
  Map map = corner();
  connect(map, 2, 1);
  EXPECT_EQ(map.points[1].connected, 2);
  connect(map, 1, 1);
  EXPECT_EQ(map.points[1].connected, 2);
  EXPECT_EQ(find_broken_reference(map), "");
}

TEST(Disconnect, MakesBothEndsFloat) {
  for (const Index end : {1, 2}) {
    Map map = corner();
    map.points[1].property = PointProperty::convex;
    disconnect(map, end);
    for (const std::size_t i : {1U, 2U}) {
      EXPECT_EQ(map.points[i].connected, kNone);
      EXPECT_EQ(map.points[i].property, PointProperty::floating);
    }
  }
}

TEST(Disconnect, LeavesAPointThatIsNotConnectedAsItIs) {
  Map map = corner();
  map.points[0].property = PointProperty::convex;
  disconnect(map, 0);
  EXPECT_EQ(map.points[0].property, PointProperty::convex);
  EXPECT_EQ(map.points[1].connected, 2);
}

TEST(Disconnect, LeavesAThirdPointsConnectionAlone) {
  Map map = corner();
  map.points[0].connected = 1;  // one-sided: 1 is connected to 2
  disconnect(map, 0);
  EXPECT_EQ(map.points[0].connected, kNone);
  EXPECT_EQ(map.points[1].connected, 2);
}

TEST(Transform, RotatesFirstAndThenTranslates) {
  const Map map = corner();
  const Map moved = transform(map, {10.0, 20.0, 0.5 * pi});
  EXPECT_NEAR(distance(moved.points[1].location, Vector2(10.0, 24.0)), 0.0, 1e-14);
  EXPECT_NEAR(distance(moved.points[3].location, Vector2(7.0, 24.0)), 0.0, 1e-14);
  EXPECT_EQ(map.points[1].location, Vector2(4.0, 0.0)) << "the map itself stays";
  EXPECT_EQ(moved.points[1].connected, 2);
  EXPECT_EQ(find_broken_reference(moved), "");
}

TEST(Transform, TurnsCovariancesWithTheirPoints) {
  Map map = corner();
  map.points[0].covariance = Eigen::Vector2d(4.0, 1.0).asDiagonal();
  const Map moved = transform(map, {10.0, 20.0, 0.5 * pi});
  ASSERT_TRUE(moved.points[0].covariance.has_value());
  const Eigen::Matrix2d expected = Eigen::Vector2d(1.0, 4.0).asDiagonal();
  EXPECT_TRUE(moved.points[0].covariance->isApprox(expected, 1e-14));
  EXPECT_FALSE(moved.points[1].covariance.has_value());
}

TEST(Transform, ThereAndBackIsTheSameMap) {
  Map map = corner();
  map.points[2].covariance = Eigen::Matrix2d{{2.0, 0.5}, {0.5, 1.0}};
  const Position map_in_new{3.0, -1.0, 2.5};
  const Map back = transform(transform(map, map_in_new), inverse(map_in_new));
  for (std::size_t i = 0; i < map.points.size(); ++i)
    EXPECT_NEAR(distance(back.points[i].location, map.points[i].location), 0.0, 1e-14);
  EXPECT_TRUE(back.points[2].covariance->isApprox(*map.points[2].covariance, 1e-14));
}

TEST(Transform, OfOneObjectMovesOnlyItsPoints) {
  Map map = corner();
  map.points[2].covariance = Eigen::Vector2d(4.0, 1.0).asDiagonal();
  transform(map, map.objects[1], {0.0, 1.0, 0.5 * pi});
  EXPECT_EQ(map.points[1].location, Vector2(4.0, 0.0));
  EXPECT_NEAR(distance(map.points[2].location, Vector2(0.0, 5.0)), 0.0, 1e-14);
  EXPECT_NEAR((*map.points[2].covariance)(0, 0), 1.0, 1e-14);
}

TEST(Transform, MovesAPointOnceThoughTheRingNamesItTwice) {
  Map map;
  for (const double x : {0.0, 1.0, 2.0}) add_point(map, Vector2(x, 0.0));
  map.objects.push_back(cabinet_of({0, 1, 2, 0}));
  transform(map, map.objects[0], {5.0, 0.0, 0.0});
  EXPECT_EQ(map.points[0].location, Vector2(5.0, 0.0));
  EXPECT_EQ(map.points[2].location, Vector2(7.0, 0.0));
}

TEST(SetObjectsOld, ClearsIsNewOnEveryObject) {
  Map map = corner();
  set_objects_old(map);
  for (const Object& object : map.objects) EXPECT_FALSE(object.is_new);
}

TEST(Print, GivesOneLineForEachObject) {
  Map map = corner();
  map.objects[0].id = 7;
  map.objects[0].name = "north";
  map.objects[1].type = ObjectType::possible_door;
  map.objects[1].remove = true;
  map.objects[1].is_new = false;
  std::ostringstream out;
  print(out, map);
  EXPECT_EQ(out.str(),
            "7 wall 'north' weight 0.000: (0.000, 0.000) (4.000, 0.000) new\n"
            "-1 possible door '' weight 0.000: (4.000, 0.000) (4.000, 3.000) remove\n");
}

TEST(Print, LeavesTheStreamAsItWasFormatted) {
  std::ostringstream out;
  print(out, corner());
  out.str("");
  out << 0.12345;
  EXPECT_EQ(out.str(), "0.12345");
}

TEST(Print, NamesATypeThatItDoesNotKnow) {
  Map map = corner();
  map.objects[0].type = static_cast<ObjectType>(-1);
  std::ostringstream out;
  print(out, map);
  EXPECT_THAT(out.str(), StartsWith("-1 unknown type"));
}

struct BrokenMap {
  const char* name;
  void (*breaks)(Map&);
  const char* says;

  friend void PrintTo(const BrokenMap& map, std::ostream* out) { *out << map.name; }
};

class FindBrokenReference : public testing::TestWithParam<BrokenMap> {};

TEST_P(FindBrokenReference, SaysWhatIsWrong) {
  Map map = corner();
  ASSERT_EQ(find_broken_reference(map), "");
  GetParam().breaks(map);
  EXPECT_THAT(find_broken_reference(map), HasSubstr(GetParam().says));
}

INSTANTIATE_TEST_SUITE_P(
    EachKind, FindBrokenReference,
    testing::Values(BrokenMap{"PointBeyond", [](Map& m) { m.objects[0].points[1] = 4; },
                              "object 0 has point 4, which is not there"},
                    BrokenMap{"PointNegative", [](Map& m) { m.objects[1].points[0] = kNone; },
                              "object 1 has point -1, which is not there"},
                    BrokenMap{"PointUnaware", [](Map& m) { m.points[0].parents.clear(); },
                              "object 0 has point 0, which does not know it"},
                    BrokenMap{"ParentBeyond", [](Map& m) { m.points[2].parents.push_back(2); },
                              "point 2 has parent 2, which is not there"},
                    BrokenMap{"ParentUnaware", [](Map& m) { m.points[2].parents.push_back(0); },
                              "point 2 has parent 0, which does not know it"},
                    BrokenMap{"ConnectedBeyond", [](Map& m) { m.points[1].connected = 99; },
                              "point 1 refers to point 99, which is not there"},
                    BrokenMap{"ProjectionNegative", [](Map& m) { m.points[1].projection = -2; },
                              "point 1 refers to point -2, which is not there"},
                    BrokenMap{"ProjectedOnItself", [](Map& m) { m.points[1].projection = 1; },
                              "point 1 refers to itself"},
                    BrokenMap{"ConnectedToItself", [](Map& m) { m.points[0].connected = 0; },
                              "point 0 refers to itself"},
                    BrokenMap{"ConnectedOneSided", [](Map& m) { m.points[0].connected = 1; },
                              "point 0 is connected to point 1, which is not connected to it"}),
    [](const auto& suite) { return std::string(suite.param.name); });

TEST(Map, EdgesOfOpenAndClosedObjects) {
  Map map;
  Object object;
  for (const Vector2& corner : {Vector2(0.0, 0.0), Vector2(1.0, 0.0), Vector2(0.0, 1.0)})
    object.points.push_back(add_point(map, corner));
  EXPECT_EQ(edges(map, object).size(), 2U);
  object.connection = Connection::closed;
  const std::vector<Segment> sides = edges(map, object);
  ASSERT_EQ(sides.size(), 3U);
  EXPECT_EQ(sides[2].b, Vector2(0.0, 0.0));
  object.points.resize(2);
  EXPECT_EQ(edges(map, object).size(), 1U) << "there and back is one";
  object.points.clear();
  EXPECT_TRUE(edges(map, object).empty());
}

}  // namespace
}  // namespace perceptor
