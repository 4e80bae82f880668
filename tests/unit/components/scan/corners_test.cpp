// Corners: by which method they are seen, and where.

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "tests/unit/components/scan/scan_scene.hpp"

namespace perceptor::test {
namespace {

using namespace perceptor::scan;

TEST(Corners, OfTwoWallsLieWhereTheirLinesMeet) {
  const Map map = map_of(sweep(chain({{2.5, -1.5}, {1.5, 0}, {2.5, 1.5}}), pico_laser()));
  const std::vector<Vector2> met = seen_by(map, CornerMethod::intersection, false);
  ASSERT_EQ(met.size(), 2U);
  EXPECT_EQ(met[0], met[1]);
  EXPECT_LT(distance(met[0], {1.5, 0.0}), 1e-3);
  for (const Point& point : map.points) EXPECT_EQ(point.property, PointProperty::floating);
}

TEST(Corners, SideOfACabinetDoesNotReachTheWallBehindIt) {
  // 6 cm behind it: less than a jump in range, but beams pass through and see the wall there.
  const Vector2 behind(2.2, 0.94);
  const Scene scene = {{{1.5, -1.5}, {1.5, 0.2}}, {{1.5, 0.2}, behind}, {{3, 1.0}, {-1, 1.0}}};
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Map map = map_of(sweep(scene, pico_laser(0.01, seed), {1.9, -0.4, 1.9}));
    for (const Vector2& corner : seen_by(map, CornerMethod::intersection, false))
      EXPECT_GT(distance(corner, transform(inverse(Position{1.9, -0.4, 1.9}), behind)), 0.15)
          << "seed " << seed;
  }
}

TEST(Corners, NearerPointOfAJumpIsASpike) {
  const Scene scene = {{{1.5, -1}, {1.5, 0}}, {{3, -3}, {3, 3}}};
  const Map map = map_of(sweep(scene, pico_laser(0.01)));
  const std::vector<Vector2> spikes = seen_by(map, CornerMethod::spike, false);
  ASSERT_EQ(spikes.size(), 2U);
  EXPECT_LT(distance(spikes[0], {1.5, -1}), 0.02);
  EXPECT_LT(distance(spikes[1], {1.5, 0}), 0.02);
}

TEST(Corners, OfSomethingTooSmallForAWallStandAlone) {
  const Scene post = {{{1.5, -0.07}, {1.5, 0.07}}, {{3, -3}, {3, 3}}};
  const Map map = map_of(sweep(post, pico_laser(0.005)));
  const std::vector<Vector2> spikes = seen_by(map, CornerMethod::spike, true);
  ASSERT_EQ(spikes.size(), 2U);
  EXPECT_LT(distance(spikes[0], {1.5, -0.07}), 0.02);
  EXPECT_LT(distance(spikes[1], {1.5, 0.07}), 0.02);
  EXPECT_EQ(find_broken_reference(map), "");
}

TEST(Corners, TurnBetweenAWallAndSomethingSmallIsSeenByTheVectorMethod) {
  const Scene scene = chain({{2, -1}, {2, 0.5}, {2.14, 0.5}});
  const Map map = map_of(sweep(scene, pico_laser(0.002), {0, 1.5, 0}));
  const std::vector<Vector2> turns = seen_by(map, CornerMethod::vector, false);
  ASSERT_EQ(turns.size(), 1U);
  EXPECT_LT(distance(turns[0], {2.0, -1.0}), 0.03);
}

TEST(Corners, TurnBetweenTwoSmallThingsStandsAlone) {
  const Scene edge = chain({{1.15, -0.13}, {1.0, 0.0}, {1.15, 0.13}});
  const Map map = map_of(sweep(edge, pico_laser(0.002)));
  EXPECT_TRUE(map.objects.empty());
  const std::vector<Vector2> turns = seen_by(map, CornerMethod::vector, true);
  ASSERT_EQ(turns.size(), 1U);
  EXPECT_LT(distance(turns[0], {1.0, 0.0}), 0.02);
}

TEST(Corners, EndBesideBeamsWithoutReturnIsNoSpike) {
  // What lies beside the first wall is unknown, up to the second one far away.
  const Scene scene = {{{1.5, -1.5}, {1.5, -0.5}}, {{3, 1}, {3, 3}}};
  const Map map = map_of(sweep(scene, pico_laser(0.01)));
  ASSERT_EQ(map.objects.size(), 2U);
  EXPECT_TRUE(seen_by(map, CornerMethod::spike, false).empty());
}

TEST(Corners, SingleStrayBeamsAreNone) {
  LaserScan scan = sweep({{{2, -2}, {2, 2}}}, pico_laser(0.01));
  scan.ranges[500] = 0.8;
  scan.ranges[550] = 5.0;
  const Map map = map_of(scan);
  EXPECT_EQ(map.objects.size(), 1U);
  EXPECT_EQ(map.points.size(), 2U);
}

/// Squared error in units of its covariance: on average the number of dimensions.
double normalised(const Eigen::Vector2d& error, const Eigen::Matrix2d& covariance) {
  return error.dot(covariance.inverse() * error);
}

TEST(Covariance, OfLinesAndCornersIsHonest) {
  constexpr int kScans = 500;
  const Segment first{{2.5, -1.5}, {1.5, 0}};
  const Scene scene = {first, {{1.5, 0}, {2.5, 1.5}}};
  ScanParameters parameters;
  parameters.noise.surface_roughness = 0.0;  // the walls of this scene are smooth
  parameters.noise.sigma_growth = 0.0;
  WallExtractor extractor(parameters);
  double line = 0.0;
  double corner = 0.0;
  for (int seed = 1; seed <= kScans; ++seed) {
    const LaserScan scan = sweep(scene, pico_laser(0.01, static_cast<std::uint64_t>(seed)));
    const Map map = current_map(extractor.extract(scan), parameters.corner);
    ASSERT_EQ(map.objects.size(), 2U);
    const Segment wall = segment(map, 0);
    const Vector2 middle_of_wall = middle(wall);
    const double turned = angle_between(first, wall);
    const Eigen::Vector2d error(signed_distance(first, middle_of_wall),
                                std::remainder(turned, 2.0 * std::numbers::pi));
    line += normalised(error, *map.objects[0].line_covariance);
    const Point& end = map.points[1];
    ASSERT_EQ(end.method, CornerMethod::intersection);
    corner += normalised(end.location - scene[0].b, *end.covariance);
  }
  // The mean of 500 of them scatters by 0.09 about 2; beams near the corner that are taken
  // for the wrong wall add a little.
  EXPECT_NEAR(line / kScans, 2.0, 0.4);
  EXPECT_NEAR(corner / kScans, 2.0, 0.4);
}

TEST(Covariance, IsLargerWithMoreNoise) {
  const Scene scene = {{{2, -1}, {2, 1}}};
  const Map quiet = map_of(sweep(scene, pico_laser(0.005)));
  const Map loud = map_of(sweep(scene, pico_laser(0.03)));
  ASSERT_EQ(quiet.objects.size(), 1U);
  ASSERT_EQ(loud.objects.size(), 1U);
  EXPECT_LT((*quiet.objects[0].line_covariance)(0, 0), (*loud.objects[0].line_covariance)(0, 0));
  EXPECT_GT(quiet.objects[0].weight, loud.objects[0].weight);
}

}  // namespace
}  // namespace perceptor::test
