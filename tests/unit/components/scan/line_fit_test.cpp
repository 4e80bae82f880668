// The line through a run of beams, and how beams are resampled and clustered.

#include <gtest/gtest.h>

#include "components/scan/angle_clustering.hpp"
#include "components/scan/runs.hpp"
#include "tests/unit/components/scan/scan_scene.hpp"

namespace perceptor::test {
namespace {

using namespace perceptor::scan;

Beams beams_of(const LaserScan& scan) { return usable_beams(scan, {}, {}, ScanParameters{}); }

TEST(LineFit, HasNoBadDirection) {
  for (double turn = -3.1; turn < 3.2; turn += 0.1) {
    const Segment wall = transform(Position{0, 0, turn}, Segment{{1.5, -1.0}, {1.5, 1.0}});
    SceneLaser laser;
    laser.bearings = circle(720, turn - 3.0);
    const Beams beams = beams_of(sweep({wall}, laser));
    const PrefixMoments sums(beams);
    const Line line = fit_line(sums.of(0, beams.count), beams.laser);
    EXPECT_NEAR(line.direction.dot(direction(wall)), 1.0, 1e-9) << "turned by " << turn;
    EXPECT_NEAR(signed_distance(wall, line.point), 0.0, 1e-9);
    EXPECT_GT(offset(line, Vector2::Zero()), 0.0) << "the laser is on the left";
  }
}

TEST(LineFit, MisfitIsAboutTheNumberOfBeamsWhereTheNoiseIsAsSaid) {
  NoiseParameters noise;
  noise.surface_roughness = 0.0;
  const Beams beams = beams_of(sweep({{{2, -3}, {2, 3}}}, pico_laser(0.01)));
  const PrefixMoments sums(beams);
  const auto n = static_cast<double>(beams.count);
  // Chi-square of n - 2 degrees of freedom scatters by sqrt(2 n).
  EXPECT_NEAR(misfit(sums.of(0, beams.count), noise).chi_square, n - 2, 4.0 * std::sqrt(2.0 * n));
}

TEST(LineFit, IntersectionIsWhereLinesMeet) {
  const Line across = make_line({0, 2}, {1, 0}, Vector2::Zero());
  const Line up = make_line({3, 0}, {0, 1}, Vector2::Zero());
  EXPECT_LT(distance(intersection(across, up), {3, 2}), 1e-12);
}

TEST(Runs, TwoHalvesOfOneWallAreOneLineAndACornerIsNot) {
  const Beams flat = beams_of(sweep({{{2, -2}, {2, 2}}}, pico_laser(0.01)));
  const PrefixMoments flat_sums(flat);
  const std::size_t half = flat.count / 2;
  EXPECT_TRUE(one_line_explains(flat_sums.of(0, half), flat_sums.of(half, flat.count), {}));

  const Beams bent = beams_of(sweep(chain({{2.3, -2}, {2, 0}, {2.3, 2}}), pico_laser(0.01)));
  const PrefixMoments bent_sums(bent);
  const std::size_t corner = bent.count / 2;
  EXPECT_FALSE(one_line_explains(bent_sums.of(0, corner), bent_sums.of(corner, bent.count), {}));
}

TEST(Resample, KeepsADistanceThatGrowsWithSigma) {
  for (const double sigma : {0.001, 0.02, 0.05}) {
    ClusterParameters cluster;
    SceneLaser laser = pico_laser();
    laser.claimed_sigma = sigma;
    const Beams beams = beams_of(sweep({{{1, -2}, {1, 2}}}, laser));
    const std::vector<ResampledPoint> points = resample(beams, 0, beams.count, cluster);
    ASSERT_GT(points.size(), 3U);
    EXPECT_EQ(points.front().begin, 0U);
    EXPECT_EQ(points.back().end, beams.count);
    for (std::size_t i = 0; i + 2 < points.size(); ++i) {
      const double least = spacing(beams[points[i].begin], cluster);
      EXPECT_GE(least, cluster.spacing_sigmas * sigma);
      // Means of two neighbouring groups are as far apart as the groups are long, to a beam.
      EXPECT_GT(distance(points[i].location, points[i + 1].location), 0.8 * least);
    }
  }
}

TEST(AngleClusters, BeginAtCorners) {
  const std::vector<Vector2> corners = {{2, -1.5}, {2, 0.5}, {1, 0.5}};
  const Beams beams = beams_of(sweep(chain(corners), pico_laser(0.01)));
  const std::vector<std::size_t> begins = angle_clusters(beams, 0, beams.count, {});
  ASSERT_GE(begins.size(), 2U);
  EXPECT_EQ(begins.front(), 0U);
  for (std::size_t i = 1; i < begins.size(); ++i)
    EXPECT_LT(distance(beams[begins[i]].location, corners[1]), 0.2);
}

TEST(AngleClusters, StraightWallIsSeldomMoreThanOneCluster) {
  std::size_t clusters = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Beams beams = beams_of(sweep({{{2, -2}, {2, 2}}}, pico_laser(0.01, seed)));
    clusters += angle_clusters(beams, 0, beams.count, {}).size();
  }
  EXPECT_LE(clusters, 22U) << "in 20 scans";
}

}  // namespace
}  // namespace perceptor::test
