/// Scans of a room with a doorway, through the real wall extraction, into merge.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "common/geometry/angle.hpp"
#include "components/merge/merger.hpp"
#include "components/scan/current_map.hpp"
#include "tests/support/scene.hpp"

namespace perceptor::merge {
namespace {

/// A room of 5 m by 4 m; in its upper wall, 0.2 m thick, a doorway of 0.9 m to a corridor.
test::Scene room_with_doorway() {
  test::Scene scene = test::chain({{2.0, 4.2},
                                   {2.0, 4.0},
                                   {0.0, 4.0},
                                   {0.0, 0.0},
                                   {5.0, 0.0},
                                   {5.0, 4.0},
                                   {2.9, 4.0},
                                   {2.9, 4.2}});
  const test::Scene corridor = test::chain({{-3.0, 4.2}, {2.0, 4.2}});
  const test::Scene other_side = test::chain({{2.9, 4.2}, {8.0, 4.2}});
  const test::Scene far_wall = test::chain({{8.0, 6.0}, {-3.0, 6.0}});
  for (const test::Scene& part : {corridor, other_side, far_wall})
    scene.insert(scene.end(), part.begin(), part.end());
  return scene;
}

/// The room's own walls, free space on their left.
const std::vector<Segment> kRoomWalls = {{{0.0, 0.0}, {5.0, 0.0}},
                                         {{5.0, 0.0}, {5.0, 4.0}},
                                         {{5.0, 4.0}, {2.9, 4.0}},
                                         {{2.0, 4.0}, {0.0, 4.0}},
                                         {{0.0, 4.0}, {0.0, 0.0}}};

/// An ellipse through the room, once in 40 s.
Position tour(double seconds) {
  const double phase = 2.0 * std::numbers::pi * seconds / 40.0;
  return {2.5 + 1.5 * std::cos(phase), 2.0 + 1.0 * std::sin(phase),
          wrap_angle(std::atan2(std::cos(phase), -1.5 * std::sin(phase)))};
}

bool faces_alike(const Segment& s, const Segment& t) {
  return direction(s).dot(direction(t)) > 0.97;
}

/// Two walls where one is: the same face twice.
bool is_double(const Segment& s, const Segment& t) {
  return faces_alike(s, t) && mutual_perpendicular_distance(s, t) < 0.1 &&
         gap_distance(s, t) == 0.0;
}

std::string text(const Segment& s) {
  const auto number = [](double value) { return std::to_string(value) + " "; };
  return number(s.a.x()) + number(s.a.y()) + number(s.b.x()) + number(s.b.y());
}

TEST(SimulatedDrive, RoomHasItsWallsOnceAndThePoseStaysTrue) {
  const test::Scene scene = room_with_doorway();
  Merger merger({});
  scan::WallExtractor extractor({});
  Position odometry = tour(0.0);
  LocalMap local;
  double worst_distance = 0.0;
  double worst_heading = 0.0;
  int rejected = 0;
  constexpr double kRate = 10.0;
  for (int i = 0; i < 600; ++i) {
    const Position truth = tour(i / kRate);
    if (i > 0) {
      const Position motion = relative(tour((i - 1) / kRate), truth);
      odometry = compose(odometry, {1.03 * motion.x, 1.03 * motion.y, 1.01 * motion.a});
    }
    const LaserScan scan =
        test::sweep(scene, test::pico_laser(0.01, static_cast<std::uint64_t>(i)), truth);
    const Map walls = scan::current_map(extractor.extract(scan), {});
    local = merger.update({100'000LL * (i + 1), odometry, {}, walls});
    rejected += local.rejected ? 1 : 0;
    const Position& pose = local.robot_in_local.pose;
    worst_distance = std::max(worst_distance, distance(pose.location(), truth.location()));
    worst_heading = std::max(worst_heading, std::abs(angle_difference(truth.a, pose.a)));
  }
  EXPECT_EQ(rejected, 0);
  EXPECT_LT(worst_distance, 0.02);
  EXPECT_LT(worst_heading, 0.3 * std::numbers::pi / 180.0);

  const Map map = transform(local.walls, local.robot_in_local.pose);
  EXPECT_EQ(find_broken_reference(map), "");
  for (const Segment& wall : kRoomWalls) {
    int found = 0;
    for (const Object& object : map.objects) {
      const Segment seen = segment(map, object);
      const bool is_this_wall = faces_alike(wall, seen) && distance(wall.a, seen.a) < 0.03 &&
                                distance(wall.b, seen.b) < 0.03;
      found += is_this_wall ? 1 : 0;
    }
    EXPECT_EQ(found, 1) << text(wall);
  }
  std::string all;
  for (const Object& object : map.objects) all += text(segment(map, object)) + "\n";
  for (std::size_t i = 0; i < map.objects.size(); ++i)
    for (std::size_t j = i + 1; j < map.objects.size(); ++j)
      EXPECT_FALSE(is_double(segment(map, map.objects[i]), segment(map, map.objects[j]))) << all;
  // The room's five walls, two jambs, and what is seen of the corridor's far wall.
  EXPECT_LE(map.objects.size(), 8U) << all;
}

}  // namespace
}  // namespace perceptor::merge
