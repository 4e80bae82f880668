/// @file What every map in config/maps must be: drawn in closed loops, without overlaps, and
/// such that the robot can drive to every room and in front of every cabinet.
#include <algorithm>
#include <map>
#include <numbers>
#include <set>

#include <gmock/gmock.h>

#include "common/floorplan/floorplan.hpp"
#include "tests/unit/common/floorplan/drivable.hpp"

namespace perceptor {
namespace {

using testing::AllOf;
using testing::Each;
using testing::Ge;
using testing::IsEmpty;
using testing::Le;

const std::filesystem::path kMaps = std::filesystem::path(PERCEPTOR_SOURCE_DIR) / "config/maps";

// The robot is 0.35 m wide, and drives through a door lengthways: half of that, and the
// grid's half cell, and a little.
constexpr double kClearance = 0.175 + 0.05 + 0.01;
constexpr double kBeyondDoor = 0.5;     // [m] from the middle of a door, on either side
constexpr double kBeforeCabinet = 0.4;  // [m] where the robot stands to serve a cabinet

std::vector<std::string> map_names() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(kMaps))
    if (entry.path().extension() == ".json") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

Floorplan read(const std::string& name) { return read_floorplan(kMaps / (name + ".json")); }

std::vector<Segment> segments_of(const Floorplan& plan,
                                 const std::vector<std::vector<Floorplan::Edge>>& outlines) {
  std::vector<Segment> segments;
  for (const auto& outline : outlines)
    for (const Floorplan::Edge& edge : outline) segments.push_back(plan.segment(edge));
  return segments;
}

std::vector<double> lengths_of(const std::vector<Segment>& segments) {
  std::vector<double> lengths;
  for (const Segment& segment : segments) lengths.push_back(length(segment));
  return lengths;
}

std::vector<Vector2> places_beside_doors(const Floorplan& plan) {
  std::vector<Vector2> places;
  for (const Segment& door : segments_of(plan, plan.doors))
    for (const double side : {-1.0, 1.0})
      places.emplace_back(middle(door) + side * kBeyondDoor * perpendicular(direction(door)));
  return places;
}

/// The first edge of a cabinet is its front.
std::vector<Vector2> places_before_cabinets(const Floorplan& plan) {
  std::vector<Vector2> places;
  for (const auto& cabinet : plan.cabinets) {
    Vector2 centre = Vector2::Zero();
    for (const Floorplan::Edge& edge : cabinet)
      centre += plan.segment(edge).a / static_cast<double>(cabinet.size());
    const Vector2 front = middle(plan.segment(cabinet.front()));
    places.emplace_back(front + kBeforeCabinet * unit(front - centre));
  }
  return places;
}

/// In how many regions the places lie.
std::size_t count_regions(const Drivable& drivable, const std::vector<Vector2>& places) {
  std::set<int> regions;
  for (const Vector2& place : places) {
    const auto region = drivable.region(place);
    EXPECT_TRUE(region.has_value()) << "no robot can stand at " << place.transpose();
    if (region) regions.insert(*region);
  }
  return regions.size();
}

std::size_t count_rooms(const Floorplan& plan) {
  const Drivable drivable(plan, segments_of(plan, plan.doors), kClearance);
  return count_regions(drivable, places_beside_doors(plan));
}

class OurMap : public testing::TestWithParam<std::string> {
 protected:
  Floorplan plan = read(GetParam());
};

TEST_P(OurMap, HoldsNoUnknownKeys) { EXPECT_THAT(plan.ignored, IsEmpty()); }

TEST_P(OurMap, IsDrawnInClosedLoops) {
  std::map<int, int> walls_at_point;
  for (const Floorplan::Edge& wall : plan.walls)
    for (const int end : wall) ++walls_at_point[end];
  for (const auto& [point, count] : walls_at_point) EXPECT_EQ(count, 2) << "at point " << point;
  for (const auto& cabinet : plan.cabinets) {
    ASSERT_EQ(cabinet.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(cabinet[i][1], cabinet[(i + 1) % 4][0]);
  }
}

TEST_P(OurMap, HasNoPointTwice) {
  for (std::size_t i = 0; i < plan.points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_GT(distance(plan.points[i], plan.points[j]), 0.01) << i << " and " << j;
}

TEST_P(OurMap, HasWallsAndCabinetsThatTouchOnlyInTheirCorners) {
  std::vector<Floorplan::Edge> edges = plan.walls;
  for (const auto& cabinet : plan.cabinets)
    edges.insert(edges.end(), cabinet.begin(), cabinet.end());
  const auto nearest_end = [](const Segment& s, const Segment& t) {
    return std::min({distance(s, t.a), distance(s, t.b), distance(t, s.a), distance(t, s.b)});
  };
  const auto crosses = [](const Segment& s, const Segment& t) {
    return signed_distance(s, t.a) * signed_distance(s, t.b) < 0.0 &&
           signed_distance(t, s.a) * signed_distance(t, s.b) < 0.0;
  };
  for (const auto& e : edges)
    for (const auto& f : edges) {
      const bool share_corner = e[0] == f[0] || e[0] == f[1] || e[1] == f[0] || e[1] == f[1];
      if (share_corner) continue;
      EXPECT_FALSE(crosses(plan.segment(e), plan.segment(f)));
      EXPECT_GT(nearest_end(plan.segment(e), plan.segment(f)), 0.1)
          << "[" << e[0] << ", " << e[1] << "] and [" << f[0] << ", " << f[1] << "]";
    }
}

TEST_P(OurMap, HasNoWallThatFoldsBack) {
  for (const auto& e : plan.walls)
    for (const auto& f : plan.walls) {
      if (e[1] != f[0]) continue;
      const double turn = angle_between(plan.segment(e), plan.segment(f));
      EXPECT_GT(std::abs(turn - std::numbers::pi), 0.5) << "at point " << e[1];
    }
}

TEST_P(OurMap, ListsDoorsBetweenWallCornersWideEnoughForTheRobot) {
  EXPECT_FALSE(plan.doors.empty());
  EXPECT_THAT(lengths_of(segments_of(plan, plan.doors)), Each(AllOf(Ge(0.799), Le(1.001))));
  std::set<int> wall_points;
  for (const Floorplan::Edge& wall : plan.walls) wall_points.insert(wall.begin(), wall.end());
  for (const auto& door : plan.doors) {
    ASSERT_EQ(door.size(), 1U);
    for (const int end : door.front()) EXPECT_TRUE(wall_points.contains(end)) << end;
  }
}

TEST_P(OurMap, LetsTheRobotReachEveryRoomAndEveryCabinet) {
  std::vector<Vector2> places = places_beside_doors(plan);
  const std::vector<Vector2> fronts = places_before_cabinets(plan);
  places.insert(places.end(), fronts.begin(), fronts.end());
  EXPECT_EQ(count_regions(Drivable(plan, {}, kClearance), places), 1U);
}

TEST_P(OurMap, HasDoorsThatPartRoomsWhenShut) { EXPECT_GE(count_rooms(plan), 2U); }

INSTANTIATE_TEST_SUITE_P(All, OurMap, testing::ValuesIn(map_names()),
                         [](const auto& test) { return test.param; });

TEST(OurMaps, AreThere) {
  EXPECT_THAT(map_names(), testing::IsSupersetOf({"escape_room", "hospital", "office"}));
}

TEST(OurMaps, EscapeRoomHasOneWayOutIntoAHallway) {
  const Floorplan plan = read("escape_room");
  EXPECT_THAT(lengths_of(segments_of(plan, plan.doors)),
              testing::ElementsAre(testing::DoubleNear(0.8, 1e-9)));
  // The hallway is open at its far end: the two sides of the exit are inside and outside.
  const Vector2 outside = plan.points.front() - Vector2(1.0, 1.0);
  const Drivable shut(plan, segments_of(plan, plan.doors), kClearance);
  const std::vector<Vector2> beside_exit = places_beside_doors(plan);
  EXPECT_NE(shut.region(beside_exit[0]), shut.region(beside_exit[1]));
  const bool leads_out = shut.region(beside_exit[0]) == shut.region(outside) ||
                         shut.region(beside_exit[1]) == shut.region(outside);
  EXPECT_TRUE(leads_out);
}

TEST(OurMaps, HospitalHasSixRoomsACorridorAndCabinets) {
  const Floorplan plan = read("hospital");
  EXPECT_EQ(count_rooms(plan), 7U);
  EXPECT_EQ(plan.doors.size(), 7U);
  EXPECT_EQ(plan.cabinets.size(), 6U);
  EXPECT_THAT(lengths_of(segments_of(plan, plan.cabinets)), Each(AllOf(Ge(0.399), Le(0.601))));
}

TEST(OurMaps, OfficeHasThreeRoomsAndSlantedWalls) {
  const Floorplan plan = read("office");
  EXPECT_EQ(count_rooms(plan), 3U);
  const Segment along_x = {Vector2(0.0, 0.0), Vector2(1.0, 0.0)};
  const auto is_slanted = [&](const Floorplan::Edge& wall) {
    const double slant = smallest_relative_angle(along_x, plan.segment(wall));
    return slant > 0.1 && slant < std::numbers::pi / 2 - 0.1;
  };
  EXPECT_GE(std::count_if(plan.walls.begin(), plan.walls.end(), is_slanted), 12);
}

}  // namespace
}  // namespace perceptor
