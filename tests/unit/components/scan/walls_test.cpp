// Which walls a scan shows, and where.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/geometry/angle.hpp"
#include "tests/unit/components/scan/scan_scene.hpp"

namespace perceptor::test {
namespace {

using namespace perceptor::scan;

// Beams of a noiseless scan of pieces less than 4 m away are less than this apart on them, seen
// under more than 45 degrees; a wall's loose end is known no better [m].
constexpr double kBeamSpacing = 0.025;

SceneLaser circle_laser(double sigma = 0.0, std::uint64_t seed = 1) {
  return {.bearings = circle(1000), .laser_in_robot = {}, .sigma = sigma, .seed = seed};
}

TEST(Walls, OneWallIsSeenFromItsLeft) {
  const Segment wall{{2.0, -1.0}, {2.0, 1.0}};
  const Map map = map_of(sweep({wall}, pico_laser()));
  ASSERT_EQ(map.objects.size(), 1U);
  EXPECT_TRUE(is_near(segment(map, 0), wall, kBeamSpacing));
  EXPECT_EQ(map.objects[0].type, ObjectType::wall);
  EXPECT_EQ(map.objects[0].free_side, FreeSide::left);
  EXPECT_GT(signed_distance(segment(map, 0), Vector2::Zero()), 0.0);
  EXPECT_GT(map.objects[0].support, 200);
  EXPECT_GT(map.objects[0].weight, 0.0);
  EXPECT_TRUE(map.objects[0].line_covariance.has_value());
  for (const Point& point : map.points) {
    EXPECT_EQ(point.property, PointProperty::floating);
    EXPECT_EQ(point.method, CornerMethod::none);
    EXPECT_TRUE(point.covariance.has_value());
    EXPECT_DOUBLE_EQ(point.radius, ScanParameters{}.corner.connection_radius);
    EXPECT_GT(point.weight, 0.0);
  }
  EXPECT_EQ(find_broken_reference(map), "");
}

class RoomFromPose : public testing::TestWithParam<Position> {};

TEST_P(RoomFromPose, ShowsItsFourWallsFromCornerToCorner) {
  const Map map = map_of(sweep(room(room_corners()), circle_laser(), GetParam()));
  EXPECT_TRUE(shows_the_room(map, GetParam(), 1e-3));
  EXPECT_EQ(seen_by(map, CornerMethod::intersection, false).size(), 8U);
  EXPECT_TRUE(seen_by(map, CornerMethod::spike, true).empty());
  EXPECT_TRUE(seen_by(map, CornerMethod::vector, true).empty());
}

INSTANTIATE_TEST_SUITE_P(Poses, RoomFromPose,
                         testing::Values(Position{0, 0, 0}, Position{1.5, -1.0, 0.5},
                                         Position{-1.7, 1.2, 3.1}, Position{0.3, 1.3, -2.0},
                                         Position{1.9, 0.0, std::numbers::pi},
                                         Position{-1.0, -1.2, std::numbers::pi / 4}));

TEST(Walls, AreOrderedByBearing) {
  const std::vector<Segment> walls =
      walls_of(map_of(sweep(room(room_corners()), circle_laser(), {0.2, 0.1, 0.4})));
  std::vector<double> bearings;
  for (const Segment& wall : walls) bearings.push_back(angle(wall.a));
  EXPECT_TRUE(std::ranges::is_sorted(bearings));
}

TEST(Walls, DoorwayLeavesTwoWallsAndShowsTheCorridorBehind) {
  const Scene scene = {{{2, -2}, {2, -0.4}}, {{2, 0.4}, {2, 2}}, {{3.5, -3}, {3.5, 3}}};
  const std::vector<Segment> walls = walls_of(map_of(sweep(scene, pico_laser(0.01))));
  ASSERT_EQ(walls.size(), 3U);
  EXPECT_TRUE(has_wall(walls, {{2, -2}, {2, -0.4}}, kBeamSpacing));
  EXPECT_TRUE(has_wall(walls, {{2, 0.4}, {2, 2}}, kBeamSpacing));
  EXPECT_TRUE(has_wall(walls, {{3.5, -0.7}, {3.5, 0.7}}, kBeamSpacing));
}

TEST(Walls, FlatCornerOfFifteenDegreesIsACorner) {
  const double slope = std::tan(15.0 * kDegree);
  const std::vector<Vector2> corners = {{2, -2}, {2, 0}, {2 - 2 * slope, 2}};
  const std::vector<Segment> walls = walls_of(map_of(sweep(chain(corners), pico_laser(0.01))));
  ASSERT_EQ(walls.size(), 2U);
  // At 15 degrees, an offset of 1 mm moves the intersection by 4 mm along the wall.
  EXPECT_LT(distance(walls[0].b, corners[1]), 0.02);
  EXPECT_EQ(walls[0].b, walls[1].a);
}

TEST(Walls, GrazedWallIsSeenWithItsDirection) {
  const Segment wall{{0.5, 0.3}, {4.0, 0.3}};
  const std::vector<Segment> walls = walls_of(map_of(sweep({wall}, pico_laser(0.01))));
  ASSERT_EQ(walls.size(), 1U);
  EXPECT_LT(smallest_relative_angle(walls[0], wall), 0.2 * kDegree);
  EXPECT_LT(std::abs(signed_distance(wall, middle(walls[0]))), 0.005);
  // Beams meet it at 5 degrees 3.4 m ahead; what lies behind jumps too far from beam to beam.
  EXPECT_GT(length(walls[0]), 2.85);
}

class RoomUnderNoise : public testing::TestWithParam<double> {};

TEST_P(RoomUnderNoise, ShowsTheSameWallsWithTheSameParameters) {
  const double sigma = GetParam();
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    const Position robot{0.5, 0.2, 0.1 * static_cast<double>(seed)};
    const Map map = map_of(sweep(room(room_corners()), circle_laser(sigma, seed), robot));
    // A corner is known to about sigma / 5 here; five times that.
    EXPECT_TRUE(shows_the_room(map, robot, sigma)) << "seed " << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(Sigma, RoomUnderNoise, testing::Values(0.003, 0.01, 0.03));

TEST(Walls, OutliersAndDropoutsDoNotCutWalls) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    SceneLaser laser = circle_laser(0.01, seed);
    laser.outliers = 0.02;
    laser.dropouts = 0.05;
    const Map map = map_of(sweep(room(room_corners()), laser));
    EXPECT_TRUE(shows_the_room(map, {}, 0.015)) << "seed " << seed;
  }
}

TEST(Walls, ObjectInFrontCutsAWallOnlyWhereItHidesIt) {
  const Scene scene = {{{3, -2}, {3, 2}}, {{1.5, -0.3}, {1.5, 0.3}}};
  const std::vector<Segment> walls = walls_of(map_of(sweep(scene, pico_laser(0.01))));
  ASSERT_EQ(walls.size(), 3U);
  EXPECT_TRUE(has_wall(walls, {{3, -2}, {3, -0.6}}, kBeamSpacing));
  EXPECT_TRUE(has_wall(walls, {{1.5, -0.3}, {1.5, 0.3}}, kBeamSpacing));
  EXPECT_TRUE(has_wall(walls, {{3, 0.6}, {3, 2}}, kBeamSpacing));
}

TEST(Walls, ShortOnesAreLeftOut) {
  const Scene scene = {{{2, -0.08}, {2, 0.08}}};
  EXPECT_TRUE(map_of(sweep(scene, pico_laser(0.01))).objects.empty());
}

TEST(Walls, RoundColumnIsNoWall) {
  std::vector<Vector2> outline;
  for (const double a : circle(60)) outline.emplace_back(2 + 0.2 * std::cos(a), 0.2 * std::sin(a));
  for (const Segment& wall : walls_of(map_of(sweep(room(outline), pico_laser(0.01)))))
    EXPECT_LT(length(wall), 0.3);
}

TEST(Walls, BeamsOnTheRobotItselfAreLeftOut) {
  const Scene scene = {{{0.3, -0.3}, {0.3, 0.3}}, {{2, -2}, {2, 2}}};
  const std::vector<Vector2> footprint = {{0.4, -0.4}, {0.4, 0.4}, {-0.4, 0.4}, {-0.4, -0.4}};
  const LaserScan scan = sweep(scene, pico_laser());
  WallExtractor extractor({}, footprint);
  const Extraction& found = extractor.extract(scan);
  // 45 degrees to both sides end on the robot.
  EXPECT_NEAR(static_cast<double>(found.in_footprint), 1000.0 * (90 * kDegree) / 4.0, 2.0);
  EXPECT_EQ(found.no_return, scan.size() - count_returns(scan));
  for (const Wall& wall : found.walls) EXPECT_GT(wall.first.location.x(), 1.0);
}

TEST(Walls, LaserThatIsMountedTurnedAndMovedSeesTheSame) {
  SceneLaser laser = circle_laser();
  laser.laser_in_robot = {0.2, -0.1, 2.5};
  EXPECT_TRUE(shows_the_room(map_of(sweep(room(room_corners()), laser)), {}, 1e-3));
}

TEST(Walls, TurningRobotSeesThemAsStraightAsAStandingOne) {
  const Scene scene = room(room_corners());
  SceneLaser laser = circle_laser();
  laser.sweep_time = 0.02;
  const Position robot{0.4, -0.3, 0.7};
  const Twist twist{.vx = 0.4, .vy = -0.2, .va = 1.2};
  const LaserScan scan = sweep(scene, laser, robot, twist);
  EXPECT_TRUE(shows_the_room(map_of(scan, twist), robot, 2e-3));
  const std::vector<Segment> walls = walls_of(map_of(scan, twist));
  for (const Segment& piece : scene) {
    const Segment expected = transform(inverse(robot), piece);
    const auto wall = std::ranges::min_element(
        walls, {}, [&](const Segment& w) { return distance(middle(w), middle(expected)); });
    EXPECT_LT(smallest_relative_angle(*wall, expected), 0.1 * kDegree);
  }
  EXPECT_FALSE(shows_the_room(map_of(scan), robot, 2e-3)) << "the test would show nothing";
}

TEST(Scan, WithoutAnyBeamGivesAnEmptyMap) {
  const Map map = map_of({});
  EXPECT_TRUE(map.objects.empty());
  EXPECT_TRUE(map.points.empty());
}

TEST(Scan, OfFewBeamsGivesAnEmptyMap) {
  for (std::size_t beams = 1; beams <= 5; ++beams) {
    SceneLaser laser;
    laser.bearings = beams == 1 ? std::vector<double>{0.0} : fan(beams, -0.1, 0.1);
    WallExtractor extractor({});
    const Extraction& found = extractor.extract(sweep({{{2, -1}, {2, 1}}}, laser));
    EXPECT_TRUE(found.walls.empty()) << beams << " beams";
    EXPECT_EQ(found.no_return, 0U);
  }
}

TEST(Scan, WithoutReturnsGivesAnEmptyMap) {
  WallExtractor extractor({});
  const Extraction& found = extractor.extract(sweep({}, pico_laser()));
  EXPECT_TRUE(found.walls.empty());
  EXPECT_EQ(found.no_return, 1000U);
}

TEST(Scan, OfTenThousandBeamsShowsTheRoom) {
  SceneLaser laser = circle_laser(0.01);
  laser.bearings = circle(10000);
  EXPECT_TRUE(shows_the_room(map_of(sweep(room(room_corners()), laser)), {}, 0.005));
}

TEST(Scan, AllBeamsInOneDirectionGiveNoWall) {
  SceneLaser laser = pico_laser(0.01);
  laser.bearings.assign(100, 0.3);
  EXPECT_TRUE(map_of(sweep({{{2, -1}, {2, 1}}}, laser)).objects.empty());
}

TEST(Scan, BeginningAnywhereInACircleShowsTheSameWalls) {
  const Position robot{0.6, -0.4, 0.2};
  for (int i = 0; i < 40; ++i) {
    SceneLaser laser = circle_laser();
    laser.bearings = circle(1000, -std::numbers::pi + 0.157 * i);
    const Map map = map_of(sweep(room(room_corners()), laser, robot));
    EXPECT_TRUE(shows_the_room(map, robot, 1e-3)) << "first beam at step " << i;
  }
}

TEST(Scan, SeamOfAnOpenPlaceDoesNotCutTheWallBehind) {
  const Segment behind{{-2, 1}, {-2, -1}};
  const std::vector<Segment> walls = walls_of(map_of(sweep({behind}, circle_laser(0.01))));
  ASSERT_EQ(walls.size(), 1U);
  EXPECT_TRUE(is_near(walls[0], behind, kBeamSpacing));
}

TEST(Scan, IrregularClockwiseBeamsShowTheRoom) {
  SceneLaser laser = circle_laser(0.01);
  laser.bearings = fan(700, std::numbers::pi, -std::numbers::pi);
  for (std::size_t i = 0; i < laser.bearings.size(); ++i)
    laser.bearings[i] += 0.003 * std::sin(static_cast<double>(7919 * i));
  EXPECT_TRUE(shows_the_room(map_of(sweep(room(room_corners()), laser)), {}, 0.01));
}

TEST(Scan, RotatedRotatesItsWalls) {
  const LaserScan scan = sweep(room(room_corners()), pico_laser(0.01), {0.3, 0.2, 0.0});
  LaserScan rotated = scan;
  for (double& bearing : rotated.bearings) bearing += 0.7;
  const std::vector<Segment> before = walls_of(map_of(scan));
  const std::vector<Segment> after = walls_of(map_of(rotated));
  ASSERT_EQ(before.size(), after.size());
  for (const Segment& wall : before)
    EXPECT_TRUE(has_wall(after, transform(Position{0, 0, 0.7}, wall), 1e-6));
}

TEST(Scan, MirroredMirrorsItsWalls) {
  const LaserScan scan = sweep(room(room_corners()), pico_laser(0.01), {0.3, 0.2, 0.0});
  LaserScan mirrored = scan;
  for (double& bearing : mirrored.bearings) bearing = -bearing;
  const std::vector<Segment> before = walls_of(map_of(scan));
  const std::vector<Segment> after = walls_of(map_of(mirrored));
  ASSERT_EQ(before.size(), after.size());
  const auto mirror = [](const Vector2& v) { return Vector2(v.x(), -v.y()); };
  for (const Segment& wall : before)
    EXPECT_TRUE(has_wall(after, {mirror(wall.b), mirror(wall.a)}, 1e-3));
}

}  // namespace
}  // namespace perceptor::test
