#include "components/proximity/surroundings.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "common/geometry/position.hpp"

namespace perceptor {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kDegree = kPi / 180.0;
constexpr double kRounding = 1e-9;  // [m], [rad]
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kForward = 18;  // the sector [0, 10) degrees of 36; 17 is [-10, 0)

/// An octagon about as large as PICO.
const std::vector<Vector2> kFootprint = {{0.2, 0.075},  {0.1, 0.175},   {-0.1, 0.175},
                                         {-0.2, 0.075}, {-0.2, -0.075}, {-0.1, -0.175},
                                         {0.1, -0.175}, {0.2, -0.075}};

/// `beams` beams from one bearing to another, each as long as `range` says of its bearing.
LaserScan sweep(double from, double to, int beams, const std::function<double(double)>& range) {
  LaserScan scan;
  scan.valid_min = 0.02;
  scan.valid_max = 30.0;
  for (int i = 0; i < beams; ++i) {
    const double share = beams == 1 ? 0.5 : static_cast<double>(i) / (beams - 1);
    scan.bearings.push_back(from + share * (to - from));
    scan.ranges.push_back(range(scan.bearings.back()));
  }
  return scan;
}

/// PICO's laser: 1081 beams, a quarter of a degree apart, over 270 degrees.
LaserScan pico_scan(const std::function<double(double)>& range) {
  return sweep(-135.0 * kDegree, 135.0 * kDegree, 1081, range);
}

LaserScan empty_room() {
  return pico_scan([](double) { return 3.0; });
}

bool is_between(double bearing, double from_degrees, double to_degrees) {
  return bearing >= from_degrees * kDegree - kRounding &&
         bearing <= to_degrees * kDegree + kRounding;
}

int count(const Surroundings& around, bool Sector::*property) {
  return static_cast<int>(std::ranges::count_if(around.sectors, property));
}

TEST(Surroundings, EmptyRoomIsFarAndBlindOnlyBehind) {
  const auto around = look_around(empty_room(), kFootprint, {});
  ASSERT_EQ(around.sectors.size(), 36U);
  for (std::size_t i = 0; i < 36; ++i) {
    // The sectors [-180, -140) and [140, 180) lie outside the 270 degrees.
    const bool is_behind = i < 4 || i >= 32;
    EXPECT_EQ(around.sectors[i].blind, is_behind) << i;
    EXPECT_FALSE(around.sectors[i].too_close) << i;
    if (is_behind)
      EXPECT_EQ(around.sectors[i].distance, kInfinity) << i;
    else
      EXPECT_NEAR(around.sectors[i].distance, 3.0, kRounding) << i;
  }
  EXPECT_NEAR(around.nearest_distance, 3.0, kRounding);
  EXPECT_EQ(around.own_beams, 0);
}

TEST(Surroundings, ThinTableLegIsOneBeamWide) {
  const auto around = look_around(
      pico_scan([](double bearing) { return is_between(bearing, 45.2, 45.3) ? 0.3 : 3.0; }),
      kFootprint, {});
  EXPECT_EQ(count(around, &Sector::too_close), 1);
  const Sector& sector = around.sectors[22];  // [40, 50) degrees
  EXPECT_TRUE(sector.too_close);
  EXPECT_FALSE(sector.contact);
  EXPECT_NEAR(sector.distance, 0.3, kRounding);
  EXPECT_NEAR(sector.bearing, 45.25 * kDegree, kRounding);
  EXPECT_NEAR(around.nearest_distance, 0.3, kRounding);
  EXPECT_NEAR(around.nearest_bearing, 45.25 * kDegree, kRounding);
}

TEST(Surroundings, RadiusDecidesWhatIsTooClose) {
  const auto wall_at = [](double distance) {
    return sweep(0.05, 0.1, 3, [distance](double) { return distance; });
  };
  const ProximityParameters parameters{.radius = 0.5};
  const auto forward = [&](double distance) {
    return look_around(wall_at(distance), kFootprint, parameters).sectors[kForward].too_close;
  };
  EXPECT_TRUE(forward(0.499));
  EXPECT_FALSE(forward(0.501));
}

TEST(Surroundings, NoReturnIsBlindAndNeverFree) {
  for (const double no_return : {0.0, -1.0, 0.019, 30.01, kInfinity, std::nan("")}) {
    const auto around = look_around(pico_scan([no_return](double bearing) {
                                      return is_between(bearing, 0.0, 19.9) ? no_return : 3.0;
                                    }),
                                    kFootprint, {});
    EXPECT_TRUE(around.sectors[kForward].blind) << no_return;
    EXPECT_FALSE(around.sectors[kForward].too_close) << no_return;
    EXPECT_FALSE(around.sectors[kForward].contact) << no_return;
    EXPECT_EQ(around.sectors[kForward].distance, kInfinity);
    EXPECT_EQ(around.sectors[kForward].bearing, 0.0);
    EXPECT_FALSE(around.sectors[17].blind) << no_return;
  }
}

TEST(Surroundings, OneReturnAmongMissesIsSeen) {
  const auto around = look_around(
      pico_scan([](double bearing) { return is_between(bearing, 5.0, 5.0) ? 2.0 : 0.0; }),
      kFootprint, {});
  EXPECT_FALSE(around.sectors[kForward].blind);
  EXPECT_EQ(count(around, &Sector::blind), 35);
}

TEST(Surroundings, OneReturnIsNotSeenWhereTwoAreAskedForButStillTooClose) {
  const auto around = look_around(
      pico_scan([](double bearing) { return is_between(bearing, 5.0, 5.0) ? 0.3 : 0.0; }),
      kFootprint, {.min_beams_for_seen = 2});
  EXPECT_TRUE(around.sectors[kForward].blind);
  EXPECT_TRUE(around.sectors[kForward].too_close);
}

TEST(Surroundings, LastBeamsOnTheRobotItselfAreLeftOut) {
  // As on the real PICO: the beams at 134.75 and 135 degrees end on the robot; the sector
  // [130, 140) is half outside the field of view.
  const auto around = look_around(
      pico_scan([](double bearing) { return is_between(bearing, 134.75, 135.0) ? 0.11 : 2.2; }),
      kFootprint, {});
  EXPECT_EQ(around.own_beams, 2);
  EXPECT_FALSE(around.sectors[31].contact);
  EXPECT_FALSE(around.sectors[31].too_close);
  EXPECT_FALSE(around.sectors[31].blind);
  EXPECT_NEAR(around.sectors[31].distance, 2.2, kRounding);
  EXPECT_NEAR(around.nearest_distance, 2.2, kRounding);
}

TEST(Surroundings, SectorThatSeesOnlyTheRobotItselfIsBlind) {
  // The field of view ends just inside the sector [130, 140): only own beams are left in it.
  const auto around = look_around(
      sweep(-130.5 * kDegree, 130.5 * kDegree, 1045,
            [](double bearing) { return std::abs(bearing) > 129.9 * kDegree ? 0.11 : 2.2; }),
      kFootprint, {});
  for (const std::size_t i : {4U, 31U}) {
    EXPECT_TRUE(around.sectors[i].blind) << i;
    EXPECT_FALSE(around.sectors[i].contact) << i;
    EXPECT_FALSE(around.sectors[i].too_close) << i;
  }
}

TEST(Surroundings, OwnBeamsAmongMissesAreNoContact) {
  const auto around = look_around(
      pico_scan([](double bearing) { return is_between(bearing, 5.0, 5.5) ? 0.11 : 0.0; }),
      kFootprint, {});
  EXPECT_EQ(around.own_beams, 3);
  EXPECT_TRUE(around.sectors[kForward].blind);
  EXPECT_FALSE(around.sectors[kForward].contact);
}

TEST(Surroundings, BodyAgainstTheLaserIsContact) {
  const auto around = look_around(
      pico_scan([](double bearing) { return is_between(bearing, -10.0, 9.9) ? 0.12 : 3.0; }),
      kFootprint, {.radius = 0.05});
  for (const std::size_t i : {17U, 18U}) {
    EXPECT_TRUE(around.sectors[i].contact) << i;
    EXPECT_TRUE(around.sectors[i].too_close) << i;  // although beyond that radius
    EXPECT_FALSE(around.sectors[i].blind) << i;
    EXPECT_NEAR(around.sectors[i].distance, 0.12, kRounding) << i;
  }
  EXPECT_EQ(count(around, &Sector::contact), 2);
  EXPECT_NEAR(around.nearest_distance, 0.12, kRounding);
  EXPECT_EQ(around.own_beams, 0);
}

TEST(Surroundings, BodySoCloseThatSomeBeamsFailIsContact) {
  // Every second beam meets the body nearer than the laser can measure.
  int beam = 0;
  const auto around = look_around(pico_scan([&beam](double bearing) {
                                    const double body = ++beam % 2 == 0 ? 0.01 : 0.05;
                                    return is_between(bearing, 0.0, 9.9) ? body : 3.0;
                                  }),
                                  kFootprint, {});
  EXPECT_TRUE(around.sectors[kForward].contact);
  EXPECT_TRUE(around.sectors[kForward].too_close);
}

TEST(Surroundings, BodyAtTheEdgeOfTheFieldOfViewIsContact) {
  // It fills the 5 degrees of the sector [130, 140) that the laser sees.
  const auto around = look_around(
      pico_scan([](double bearing) { return is_between(bearing, 130.0, 135.0) ? 0.1 : 3.0; }),
      kFootprint, {});
  EXPECT_TRUE(around.sectors[31].contact);
  EXPECT_FALSE(around.sectors[30].contact);
}

TEST(Surroundings, MostBeamsOfTheSectorHaveToEndInside) {
  const auto inside_up_to = [](double degrees) {
    return look_around(pico_scan([degrees](double bearing) {
                         return is_between(bearing, 0.0, degrees) ? 0.1 : 0.28;
                       }),
                       kFootprint, {})
        .sectors[kForward];
  };
  EXPECT_TRUE(inside_up_to(5.1).contact);
  EXPECT_NEAR(inside_up_to(5.1).distance, 0.1, kRounding);
  EXPECT_FALSE(inside_up_to(4.4).contact);
  EXPECT_NEAR(inside_up_to(4.4).distance, 0.28, kRounding);
  EXPECT_TRUE(inside_up_to(4.4).too_close);
}

TEST(Surroundings, EdgeOfTheFootprintIsInside) {
  const auto ahead = [](double range) {
    return look_around(sweep(0.0, 0.0, 1, [range](double) { return range; }), kFootprint, {})
        .sectors[kForward];
  };
  EXPECT_TRUE(ahead(0.2).blind);  // left out; the front edge lies at x = 0.2
  EXPECT_FALSE(ahead(0.2 + 1e-6).blind);
}

TEST(Surroundings, LaserOffTheCentreIsSeenFromTheCentre) {
  // The laser sits 0.15 m ahead and looks left; a post stands left of the robot's centre.
  LaserScan scan = sweep(-135.0 * kDegree, 135.0 * kDegree, 1081, [](double) { return 0.0; });
  scan.laser_in_robot = {0.15, 0.0, kPi / 2.0};
  const Vector2 post_in_robot(0.0, 0.3);
  const Vector2 post_in_laser = transform(inverse(scan.laser_in_robot), post_in_robot);
  const auto beam = static_cast<std::size_t>(
      std::lround((angle(post_in_laser) + 135.0 * kDegree) / (0.25 * kDegree)));
  scan.ranges[beam] = length(post_in_laser);

  const auto around = look_around(scan, kFootprint, {});
  // The beam misses the bearing of the post by up to an eighth of a degree at 0.34 m.
  EXPECT_NEAR(around.nearest_distance, 0.3, 0.001);
  EXPECT_NEAR(around.nearest_bearing, kPi / 2.0, 0.003);
  EXPECT_EQ(count(around, &Sector::too_close), 1);
}

TEST(Surroundings, BodyAgainstALaserOffTheCentreIsContact) {
  // Right in front of a laser 0.15 m ahead stands a flat body, its face at x = 0.19.
  LaserScan scan = pico_scan([](double bearing) {
    return is_between(bearing, -60.0, 60.0) ? 0.04 / std::cos(bearing) : 3.0;
  });
  scan.laser_in_robot = {0.15, 0.0, 0.0};
  const auto around = look_around(scan, kFootprint, {});
  EXPECT_TRUE(around.sectors[17].contact);
  EXPECT_TRUE(around.sectors[18].contact);
  EXPECT_NEAR(around.nearest_distance, 0.19, 1e-4);
}

TEST(Surroundings, BehindTheRobotIsTheFirstSector) {
  // A beam at +180 degrees is at -180 degrees too: sector 0, not one beyond the last.
  const auto around = look_around(sweep(kPi, kPi, 1, [](double) { return 0.3; }), {}, {});
  EXPECT_TRUE(around.sectors.front().too_close);
  EXPECT_TRUE(around.sectors.back().blind);
  EXPECT_NEAR(around.nearest_bearing, kPi, kRounding);
}

TEST(Surroundings, EveryBearingFallsIntoItsSector) {
  for (const int num_sectors : {1, 2, 3, 7, 36, 120}) {
    const double width = 2.0 * kPi / num_sectors;
    for (int i = 0; i < num_sectors; ++i) {
      const double bearing = -kPi + (i + 0.5) * width;
      const auto around = look_around(sweep(bearing, bearing, 1, [](double) { return 1.0; }),
                                      kFootprint, {.num_sectors = num_sectors});
      ASSERT_EQ(around.sectors.size(), static_cast<std::size_t>(num_sectors));
      EXPECT_FALSE(around.sectors[static_cast<std::size_t>(i)].blind);
      EXPECT_EQ(count(around, &Sector::blind), num_sectors - 1);
    }
  }
}

TEST(Surroundings, ContactWithAnyNumberOfSectors) {
  for (const int num_sectors : {1, 2, 5, 36, 90}) {
    const auto around = look_around(sweep(-kPi, kPi - 0.01, 629, [](double) { return 0.1; }),
                                    kFootprint, {.num_sectors = num_sectors, .contact_share = 0.8});
    EXPECT_EQ(count(around, &Sector::contact), num_sectors);
  }
}

TEST(Surroundings, ScanOfOneBeam) {
  const auto ahead = [](double range) {
    return look_around(sweep(0.1, 0.1, 1, [range](double) { return range; }), kFootprint, {});
  };
  EXPECT_FALSE(ahead(0.3).sectors[kForward].blind);
  EXPECT_TRUE(ahead(0.3).sectors[kForward].too_close);
  // One beam covers no angle: inside the footprint it says nothing.
  EXPECT_TRUE(ahead(0.1).sectors[kForward].blind);
  EXPECT_FALSE(ahead(0.1).sectors[kForward].contact);
  EXPECT_EQ(count(ahead(0.0), &Sector::blind), 36);
}

TEST(Surroundings, ScanOfTenThousandBeams) {
  const auto around = look_around(
      sweep(-kPi, kPi - 0.0006, 10000,
            [](double bearing) { return is_between(bearing, 90.0, 90.03) ? 0.25 : 5.0; }),
      kFootprint, {});
  EXPECT_EQ(count(around, &Sector::blind), 0);
  EXPECT_EQ(count(around, &Sector::too_close), 1);
  EXPECT_TRUE(around.sectors[27].too_close);
}

TEST(Surroundings, NoBeamsAtAllIsBlindAllAround) {
  const auto around = look_around({}, kFootprint, {});
  EXPECT_EQ(count(around, &Sector::blind), 36);
  EXPECT_EQ(around.nearest_distance, kInfinity);
  EXPECT_EQ(around.nearest_bearing, 0.0);
}

TEST(Surroundings, IrregularBeamsInAnyOrder) {
  LaserScan scan = sweep(0.0, 0.0, 5, [](double) { return 2.0; });
  scan.bearings = {0.5, -3.0, 6.0, 0.02, 2.5};  // 6.0 is a little right of straight ahead
  scan.ranges = {2.0, 1.0, 0.3, 4.0, 3.0};
  const auto around = look_around(scan, kFootprint, {});
  EXPECT_NEAR(around.nearest_distance, 0.3, kRounding);
  EXPECT_NEAR(around.nearest_bearing, 6.0 - 2.0 * kPi, kRounding);
  EXPECT_EQ(count(around, &Sector::blind), 36 - 5);
}

TEST(Surroundings, BeamBesideAHoleDoesNotStandForTheHole) {
  // Sensors with irregular beams leave out what did not return: two beams of the robot
  // itself, alone in the sector, are no body however wide the hole beside them.
  LaserScan scan = pico_scan([](double bearing) { return bearing < 0.0 ? 2.0 : 0.1; });
  const std::size_t first_left = 540;  // the beam at 0 degrees
  scan.bearings.resize(first_left + 2);
  scan.ranges.resize(first_left + 2);
  scan.bearings.push_back(90.0 * kDegree);  // 90 degrees on, the next return
  scan.ranges.push_back(2.0);
  const auto around = look_around(scan, kFootprint, {});
  EXPECT_FALSE(around.sectors[kForward].contact);
  EXPECT_EQ(around.own_beams, 2);
}

TEST(Surroundings, WithoutFootprintNothingIsOwn) {
  const auto around = look_around(pico_scan([](double) { return 0.05; }), {}, {});
  EXPECT_EQ(around.own_beams, 0);
  EXPECT_EQ(count(around, &Sector::contact), 0);
  EXPECT_EQ(count(around, &Sector::too_close), 28);
}

}  // namespace
}  // namespace perceptor
