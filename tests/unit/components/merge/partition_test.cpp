/// The two faces of a thin partition, seen from both of its sides by a robot that drives around
/// its end.
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "components/merge/merger.hpp"
#include "components/scan/current_map.hpp"
#include "tests/support/scene.hpp"

namespace perceptor::merge {
namespace {

/// [m]
constexpr double kThickness = 0.05;

/// Its faces, free space on their left.
const Segment kUpperFace{{0.0, 2.0 + kThickness / 2.0}, {3.0, 2.0 + kThickness / 2.0}};
const Segment kLowerFace{{3.0, 2.0 - kThickness / 2.0}, {0.0, 2.0 - kThickness / 2.0}};

/// A room of 6 m by 4 m; the partition stands out from its left wall.
test::Scene room_with_partition() {
  return test::chain({{0.0, 4.0},
                      kUpperFace.a,
                      kUpperFace.b,
                      kLowerFace.a,
                      kLowerFace.b,
                      {0.0, 0.0},
                      {6.0, 0.0},
                      {6.0, 4.0},
                      {0.0, 4.0}});
}

/// Around the end from one side to the other and back, once in 40 s, looking at the partition.
Position around_the_end(double seconds) {
  const double bearing = 2.2 * std::sin(2.0 * std::numbers::pi * seconds / 40.0);
  const Vector2 place(3.0 + 1.5 * std::cos(bearing), 2.0 + 1.2 * std::sin(bearing));
  return {place.x(), place.y(), angle(Vector2(2.0, 2.0) - place)};
}

/// The walls along a face, on the side from which it is seen; local frame.
std::vector<Segment> walls_along(const Segment& face, const Map& map) {
  constexpr double kClose = 0.1;  // [m] more than the partition is thick
  std::vector<Segment> walls;
  for (const Object& object : map.objects) {
    const Segment wall = segment(map, object);
    const bool faces_alike = direction(wall).dot(direction(face)) > 0.9;
    if (faces_alike && mutual_perpendicular_distance(face, wall) < kClose &&
        gap_distance(face, wall) == 0.0)
      walls.push_back(wall);
  }
  return walls;
}

class Partition : public testing::TestWithParam<double> {};

TEST_P(Partition, FacesStayTwoWhileTheRobotDrivesAroundItsEnd) {
  const test::Scene scene = room_with_partition();
  Merger merger({});
  scan::WallExtractor extractor({});
  Position odometry = around_the_end(0.0);
  Map map;
  constexpr double kRate = 10.0;
  for (int i = 0; i < 800; ++i) {
    const Position truth = around_the_end(i / kRate);
    if (i > 0) {
      const Position motion = relative(around_the_end((i - 1) / kRate), truth);
      odometry = compose(odometry, {1.03 * motion.x, 1.03 * motion.y, 1.01 * motion.a});
    }
    const LaserScan scan =
        test::sweep(scene, test::pico_laser(GetParam(), static_cast<std::uint64_t>(i)), truth);
    const LocalMap local = merger.update(
        {100'000LL * (i + 1), odometry, {}, scan::current_map(extractor.extract(scan), {})});
    map = transform(local.walls, local.robot_in_local.pose);
    for (const Segment& face : {kUpperFace, kLowerFace}) {
      const std::vector<Segment> walls = walls_along(face, map);
      EXPECT_LE(walls.size(), 1U) << "scan " << i;
      for (const Segment& wall : walls)
        EXPECT_LT(mutual_perpendicular_distance(face, wall), 0.4 * kThickness) << "scan " << i;
    }
  }
  for (const Segment& face : {kUpperFace, kLowerFace}) {
    const std::vector<Segment> walls = walls_along(face, map);
    ASSERT_EQ(walls.size(), 1U);
    EXPECT_LT(distance(walls[0].a, face.a), 0.05);
    EXPECT_LT(distance(walls[0].b, face.b), 0.05);
  }
}

INSTANTIATE_TEST_SUITE_P(Sigma, Partition, testing::Values(0.01, 0.03));

}  // namespace
}  // namespace perceptor::merge
