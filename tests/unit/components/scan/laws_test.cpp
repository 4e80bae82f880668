// Laws that hold for any scan: moving, mirroring or re-cutting a scan does the same to its walls.

#include <gtest/gtest.h>

#include "tests/unit/components/scan/scan_scene.hpp"
#include "tools/eval/room_set.hpp"

namespace perceptor::test {
namespace {

using namespace perceptor::scan;

/// [m] Asked of each end of each wall.
constexpr double kSame = 1e-3;

/// Scans of random rooms, all around or PICO's field of view, with noise, outliers, drop-outs.
std::vector<LaserScan> scans_of_rooms(double fov, double sigma) {
  RoomScanParameters parameters;
  parameters.scans = 70;
  parameters.seed = 33;
  parameters.laser.fov = fov;
  parameters.laser.sigma = sigma;
  parameters.laser.outliers = 0.005;
  parameters.laser.dropouts = 0.01;
  std::vector<LaserScan> scans;
  for (LabelledScan& labelled : make_room_scans(parameters).scans)
    scans.push_back(std::move(labelled.scan));
  return scans;
}

/// All around, without the beam that would be the first one again.
constexpr double kCircle = 2.0 * std::numbers::pi * 999.0 / 1000.0;
constexpr double kPico = 4.0;

void expect_same_walls(const std::vector<Segment>& walls, const std::vector<Segment>& expected,
                       std::size_t scan) {
  EXPECT_EQ(walls.size(), expected.size()) << "scan " << scan;
  for (const Segment& wall : expected)
    EXPECT_TRUE(has_wall(walls, wall, kSame)) << "scan " << scan << ": no wall from "
                                              << wall.a.transpose() << " to " << wall.b.transpose();
}

class Laws : public testing::TestWithParam<double> {};

TEST_P(Laws, RotatedScanHasRotatedWalls) {
  const std::vector<LaserScan> scans = scans_of_rooms(kPico, GetParam());
  for (std::size_t i = 0; i < scans.size(); ++i) {
    const double turn = 0.37 * static_cast<double>(i);
    LaserScan rotated = scans[i];
    for (double& bearing : rotated.bearings) bearing += turn;
    std::vector<Segment> expected;
    for (const Segment& wall : walls_of(map_of(scans[i])))
      expected.push_back(transform(Position{0, 0, turn}, wall));
    expect_same_walls(walls_of(map_of(rotated)), expected, i);
  }
}

void expect_mirrored(const LaserScan& scan, std::size_t i) {
  LaserScan mirrored = scan;
  for (double& bearing : mirrored.bearings) bearing = -bearing;
  const auto mirror = [](const Vector2& v) { return Vector2(v.x(), -v.y()); };
  std::vector<Segment> expected;
  for (const Segment& wall : walls_of(map_of(scan)))
    expected.push_back({mirror(wall.b), mirror(wall.a)});
  expect_same_walls(walls_of(map_of(mirrored)), expected, i);
}

TEST_P(Laws, MirroredScanHasMirroredWalls) {
  const std::vector<LaserScan> scans = scans_of_rooms(kPico, GetParam());
  for (std::size_t i = 0; i < scans.size(); ++i) expect_mirrored(scans[i], i);
}

TEST_P(Laws, MirroredCircleHasMirroredWalls) {
  const std::vector<LaserScan> scans = scans_of_rooms(kCircle, GetParam());
  for (std::size_t i = 0; i < scans.size(); ++i) expect_mirrored(scans[i], i);
}

TEST_P(Laws, CircleMayBeginAtAnyBeam) {
  const std::vector<LaserScan> scans = scans_of_rooms(kCircle, GetParam());
  for (std::size_t i = 0; i < scans.size(); ++i) {
    const std::vector<Segment> expected = walls_of(map_of(scans[i]));
    for (const std::ptrdiff_t first : {1, 17, 333, 500, 998}) {
      LaserScan begun_there = scans[i];
      std::ranges::rotate(begun_there.ranges, begun_there.ranges.begin() + first);
      std::ranges::rotate(begun_there.bearings, begun_there.bearings.begin() + first);
      for (auto bearing = begun_there.bearings.end() - first; bearing != begun_there.bearings.end();
           ++bearing)
        *bearing += 2.0 * std::numbers::pi;
      expect_same_walls(walls_of(map_of(begun_there)), expected, i);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Sigma, Laws, testing::Values(0.003, 0.01, 0.03));

}  // namespace
}  // namespace perceptor::test
