// What every method shows, whichever way it cuts a scan into runs.

#include <gtest/gtest.h>

#include "tests/unit/components/scan/each_method.hpp"
#include "tests/unit/components/scan/scan_scene.hpp"

namespace perceptor::test {
namespace {

using namespace perceptor::scan;

using Methods = EachMethod;
INSTANTIATE_TEST_SUITE_P(All, Methods, testing::ValuesIn(kMethods), name_of);

// A beam at a corner that went to the wrong wall lies off it by no more than 3 sigmas of the
// roughness that walls may have, and moves the corner by less [m].
constexpr double kCornerBeam = 0.005;

SceneLaser circle_laser(double sigma = 0.0, std::uint64_t seed = 1) {
  return {.bearings = circle(1000), .laser_in_robot = {}, .sigma = sigma, .seed = seed};
}

/// A scan in which much goes wrong, of the room with a box in it.
LaserScan messy_scan(std::uint64_t seed) {
  Scene scene = room(room_corners());
  const Scene box = room({{0.8, 0.5}, {1.3, 0.5}, {1.3, 0.9}, {0.8, 0.9}});
  scene.insert(scene.end(), box.begin(), box.end());
  SceneLaser laser = circle_laser(0.02, seed);
  laser.outliers = 0.03;
  laser.dropouts = 0.03;
  return sweep(scene, laser, {-0.5, -0.3, 0.2 * static_cast<double>(seed)});
}

std::vector<Segment> extracted(WallExtractor& extractor, const LaserScan& scan) {
  std::vector<Segment> walls;
  for (const Wall& wall : extractor.extract(scan).walls)
    walls.push_back({wall.first.location, wall.last.location});
  return walls;
}

TEST_P(Methods, ShowTheFourWallsOfARoom) {
  for (const Position& robot : {Position{0, 0, 0}, Position{1.5, -1.0, 0.5},
                                Position{-1.5, 1.0, 3.1}, Position{1.6, 0.0, std::numbers::pi}}) {
    const LaserScan scan = sweep(room(room_corners()), circle_laser(), robot);
    EXPECT_TRUE(shows_the_room(map_of(scan, {}, parameters()), robot, kCornerBeam))
        << "seen from " << robot.x << ", " << robot.y;
  }
}

TEST_P(Methods, ShowTheRoomUnderNoise) {
  for (const double sigma : {0.003, 0.01}) {
    int shown = 0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      const Position robot{0.5, 0.2, 0.1 * static_cast<double>(seed)};
      const LaserScan scan = sweep(room(room_corners()), circle_laser(sigma, seed), robot);
      // Beams at a corner that went to the wrong wall turn it by a little: two sigmas.
      if (shows_the_room(map_of(scan, {}, parameters()), robot, 2.0 * sigma)) ++shown;
    }
    // RANSAC may take so many beams round a corner that its walls do not meet there.
    EXPECT_GE(shown, GetParam().method == ScanMethod::ransac ? 17 : 20) << "sigma " << sigma;
  }
}

TEST_P(Methods, FollowIrregularClockwiseBeams) {
  SceneLaser laser = circle_laser(0.01);
  laser.bearings = fan(700, std::numbers::pi, -std::numbers::pi);
  for (std::size_t i = 0; i < laser.bearings.size(); ++i)
    laser.bearings[i] += 0.003 * std::sin(static_cast<double>(7919 * i));
  EXPECT_TRUE(
      shows_the_room(map_of(sweep(room(room_corners()), laser), {}, parameters()), {}, 0.02));
}

TEST_P(Methods, ShowTheSameWhereverACircleBegins) {
  const Position robot{0.6, -0.4, 0.2};
  for (int i = 0; i < 20; ++i) {
    SceneLaser laser = circle_laser();
    laser.bearings = circle(1000, -std::numbers::pi + 0.314 * i);
    const LaserScan scan = sweep(room(room_corners()), laser, robot);
    EXPECT_TRUE(shows_the_room(map_of(scan, {}, parameters()), robot, kCornerBeam)) << "step " << i;
  }
}

TEST_P(Methods, DoNotCutAWallAtTheSeamOfACircle) {
  LaserScan scan = sweep(room(room_corners()), circle_laser());
  scan.ranges[500] = 9.0;  // the farthest beam, in the middle of a wall: there the circle begins
  EXPECT_TRUE(shows_the_room(map_of(scan, {}, parameters()), {}, kCornerBeam));
}

/// Of runs: in order, one after the other, with the beams between their strays.
void expect_sound(const WallExtractor& extractor) {
  const Beams& beams = extractor.sweep().beams;
  std::size_t end = 0;
  for (const RunResult& result : extractor.runs()) {
    const Run& run = result.run;
    EXPECT_LE(end, run.begin);
    EXPECT_LT(run.begin, run.end);
    EXPECT_LT(run.begin, run.solid_until);
    EXPECT_LE(run.solid_until, run.end);
    EXPECT_LE(run.begin, run.solid_from);
    EXPECT_LT(run.solid_from, run.end);
    EXPECT_LE(run.moments.beams, static_cast<double>(run.size()));
    EXPECT_GT(run.moments.beams, 0.0);
    end = run.end;
  }
  ASSERT_FALSE(extractor.runs().empty());
  const std::size_t past_seam = beams.is_circle ? extractor.runs().front().run.begin : 0;
  EXPECT_LE(end, beams.count + past_seam);
}

TEST_P(Methods, GiveRunsInOrderThatDoNotOverlap) {
  WallExtractor extractor(parameters());
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    extractor.extract(messy_scan(seed));
    expect_sound(extractor);
    const LaserScan fan_scan = sweep(room(room_corners()), pico_laser(0.01, seed));
    extractor.extract(fan_scan);
    expect_sound(extractor);
  }
}

TEST_P(Methods, DependOnTheScanAlone) {
  WallExtractor used(parameters());
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    WallExtractor fresh(parameters());
    const std::vector<Segment> expected = extracted(fresh, messy_scan(seed));
    const std::vector<Segment> walls = extracted(used, messy_scan(seed));
    ASSERT_EQ(walls.size(), expected.size());
    for (std::size_t i = 0; i < walls.size(); ++i) {
      EXPECT_EQ(walls[i].a, expected[i].a);
      EXPECT_EQ(walls[i].b, expected[i].b);
    }
  }
}

TEST_P(Methods, ShowNothingWhereThereIsNothing) {
  WallExtractor extractor(parameters());
  EXPECT_TRUE(extractor.extract({}).walls.empty());
  EXPECT_TRUE(extractor.extract(sweep({}, pico_laser())).walls.empty());
  for (std::size_t beams = 1; beams <= 5; ++beams) {
    SceneLaser laser;
    laser.bearings = beams == 1 ? std::vector<double>{0.0} : fan(beams, -0.1, 0.1);
    EXPECT_TRUE(extractor.extract(sweep({{{2, -1}, {2, 1}}}, laser)).walls.empty()) << beams;
  }
}

TEST_P(Methods, ShowNoWallInASingleDirection) {
  SceneLaser laser = pico_laser(0.01);
  laser.bearings.assign(100, 0.3);
  WallExtractor extractor(parameters());
  EXPECT_TRUE(extractor.extract(sweep({{{2, -1}, {2, 1}}}, laser)).walls.empty());
}

TEST(MethodNames, AreEachMethodsOwn) {
  for (const NamedMethod& named : kMethods) {
    EXPECT_EQ(method_of(named.method), named.function) << named.name;
    EXPECT_EQ(std::ranges::count(kMethods, named.name, &NamedMethod::name), 1);
    EXPECT_EQ(std::ranges::count(kMethods, named.method, &NamedMethod::method), 1);
  }
  EXPECT_EQ(kMethods.front().method, ScanParameters{}.method) << "the default stands first";
}

}  // namespace
}  // namespace perceptor::test
