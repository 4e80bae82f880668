// The line through a run of beams, and how beams are resampled and clustered.

#include <gtest/gtest.h>

#include "components/scan/angle_clustering.hpp"
#include "components/scan/extractor.hpp"
#include "tests/unit/components/scan/scan_scene.hpp"

namespace perceptor::test {
namespace {

using namespace perceptor::scan;

/// What the methods see of a scan.
Sweep sweep_of(const LaserScan& scan) {
  WallExtractor extractor({});
  extractor.extract(scan);
  return extractor.sweep();
}

TEST(LineFit, HasNoBadDirection) {
  for (double turn = -3.1; turn < 3.2; turn += 0.1) {
    const Segment wall = transform(Position{0, 0, turn}, Segment{{1.5, -1.0}, {1.5, 1.0}});
    SceneLaser laser;
    laser.bearings = circle(720, turn - 3.0);
    const auto [beams, sums, stretches] = sweep_of(sweep({wall}, laser));
    const Line line = make_line(polar_line(sums.of(0, beams.count)), beams.laser);
    EXPECT_NEAR(line.direction.dot(direction(wall)), 1.0, 1e-9) << "turned by " << turn;
    EXPECT_NEAR(signed_distance(wall, line.point), 0.0, 1e-9);
    EXPECT_GT(offset(line, Vector2::Zero()), 0.0) << "the laser is on the left";
  }
}

TEST(LineFit, MisfitIsAboutTheNumberOfBeamsWhereTheNoiseIsAsSaid) {
  const auto [beams, sums, stretches] = sweep_of(sweep({{{2, -3}, {2, 3}}}, pico_laser(0.01)));
  const auto n = static_cast<double>(beams.count);
  // Chi-square of n - 2 degrees of freedom scatters by sqrt(2 n).
  EXPECT_NEAR(misfit(sums.of(0, beams.count), 0.0).chi_square, n - 2, 4.0 * std::sqrt(2.0 * n));
}

TEST(LineFit, IntersectionIsWhereLinesMeet) {
  const Line across = make_line({.a = 0.0, .b = 1.0 / 2.0}, Vector2::Zero());
  const Line up = make_line({.a = 1.0 / 3.0, .b = 0.0}, Vector2::Zero());
  EXPECT_LT(distance(intersection(across, up), {3, 2}), 1e-12);
}

TEST(Runs, TwoHalvesOfOneWallAreOneLineAndACornerIsNot) {
  const Sweep flat = sweep_of(sweep({{{2, -2}, {2, 2}}}, pico_laser(0.01)));
  const std::size_t all = flat.beams.count;
  EXPECT_LT(gain_of_cut(flat.sums.of(0, all / 2), flat.sums.of(all / 2, all), {}), 0.0);

  const Sweep bent = sweep_of(sweep(chain({{2.3, -2}, {2, 0}, {2.3, 2}}), pico_laser(0.01)));
  const std::size_t corner = bent.beams.count / 2;
  EXPECT_GT(gain_of_cut(bent.sums.of(0, corner), bent.sums.of(corner, bent.beams.count), {}), 0.0);
}

TEST(Resample, KeepsADistanceThatGrowsWithSigma) {
  for (const double sigma : {0.001, 0.02, 0.05}) {
    ClusterParameters cluster;
    SceneLaser laser = pico_laser();
    laser.claimed_sigma = sigma;
    const Beams beams = sweep_of(sweep({{{1, -2}, {1, 2}}}, laser)).beams;
    std::vector<ResampledPoint> points;
    resample(beams, 0, beams.count, cluster, points);
    ASSERT_GT(points.size(), 3U);
    EXPECT_EQ(points.front().begin, 0U);
    EXPECT_EQ(points.back().end, beams.count);
    for (std::size_t i = 0; i + 2 < points.size(); ++i) {
      const double least = spacing(beams, points[i].begin, cluster);
      EXPECT_GE(least, cluster.spacing_sigmas * sigma);
      // Means of two neighbouring groups are as far apart as the groups are long, to a beam.
      EXPECT_GT(distance(points[i].location, points[i + 1].location), 0.8 * least);
    }
  }
}

std::vector<Run> clusters_of(const Sweep& seen) {
  Workspace workspace;
  std::vector<Run> runs;
  angle_clustering(seen, {}, workspace, runs);
  return runs;
}

TEST(AngleClusters, BeginAtCorners) {
  const std::vector<Vector2> corners = {{2, -1.5}, {2, 0.5}, {1, 0.5}};
  const Sweep seen = sweep_of(sweep(chain(corners), pico_laser(0.01)));
  const auto clusters = clusters_of(seen);
  ASSERT_GE(clusters.size(), 2U);
  EXPECT_EQ(clusters.front().begin, 0U);
  for (std::size_t i = 1; i < clusters.size(); ++i)
    EXPECT_LT(distance(seen.beams.location(clusters[i].begin), corners[1]), 0.2);
}

TEST(AngleClusters, StraightWallIsSeldomMoreThanOneCluster) {
  std::size_t clusters = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    clusters += clusters_of(sweep_of(sweep({{{2, -2}, {2, 2}}}, pico_laser(0.01, seed)))).size();
  }
  EXPECT_LE(clusters, 22U) << "in 20 scans";
}

}  // namespace
}  // namespace perceptor::test
