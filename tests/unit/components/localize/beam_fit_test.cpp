#include "components/localize/beam_fit.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/components/localize/building.hpp"

namespace perceptor::localize {
namespace {

void add_wall(Map& map, const Segment& wall) {
  map.objects[static_cast<std::size_t>(add_segment(map, wall, ObjectType::wall))].free_side =
      FreeSide::right;
}

/// A wall 2 m ahead with a doorway in it, and one 4 m ahead that is seen through it.
World behind_a_doorway() {
  Map map;
  add_wall(map, {{-2.0, 2.0}, {-0.5, 2.0}});
  add_wall(map, {{0.5, 2.0}, {2.0, 2.0}});
  add_wall(map, {{-2.0, 4.0}, {2.0, 4.0}});
  return World(map);
}

World behind_a_wall() {
  Map map;
  add_wall(map, {{-2.0, 2.0}, {2.0, 2.0}});
  return World(map);
}

/// Straight ahead from the origin, which is y.
std::vector<Beam> beams(double range) {
  return {{{-0.2, 0.0}, {0.0, 1.0}, range}, {{0.2, 0.0}, {0.0, 1.0}, range}};
}

BeamFit fit(const World& world, double range) {
  return fit_beams(world, {}, beams(range), BeamFitParameters{});
}

TEST(BeamFit, AShutDoorIsWorthAsMuchAsAWall) {
  const BeamFit door = fit(behind_a_doorway(), 2.0);
  const BeamFit wall = fit(behind_a_wall(), 2.0);
  EXPECT_DOUBLE_EQ(door.explained, 1.0);
  EXPECT_NEAR(door.log_likelihood, wall.log_likelihood, 0.1);
}

TEST(BeamFit, AnOpenDoorIsSeenThrough) {
  const BeamFit open = fit(behind_a_doorway(), 4.0);
  EXPECT_DOUBLE_EQ(open.explained, 1.0);
  EXPECT_DOUBLE_EQ(open.through, 0.0);
  EXPECT_DOUBLE_EQ(fit(behind_a_wall(), 4.0).through, 1.0);
}

TEST(BeamFit, WhatEndsBetweenDoorAndWallIsNotExplained) {
  const BeamFit between = fit(behind_a_doorway(), 3.0);
  EXPECT_DOUBLE_EQ(between.explained, 0.0);
  EXPECT_DOUBLE_EQ(between.through, 0.0) << "something stands behind the door";
  EXPECT_LT(between.log_likelihood, fit(behind_a_doorway(), 4.0).log_likelihood);
}

TEST(BeamFit, TruePoseFitsBestAndNothingGoesThroughWalls) {
  const Building building = angled_room();
  const World world(building.map);
  const Position robot{1.2, 1.0, 0.4};
  const auto beams =
      choose_beams(beam_ends(test::sweep(building.scene, test::pico_laser(0.01), robot)), 72);
  ASSERT_EQ(beams.size(), 72U);
  const BeamFit right = fit_beams(world, robot, beams, {});
  EXPECT_GT(right.explained, 0.95);
  EXPECT_EQ(right.through, 0.0);
  const BeamFit wrong = fit_beams(world, {1.6, 1.0, 0.4}, beams, {});
  EXPECT_LT(wrong.log_likelihood, right.log_likelihood - 50.0);
  EXPECT_GT(wrong.through, 0.1);
}

TEST(BeamFit, DrawnDoorExplainsBeams) {
  Map map;
  add_segment(map, {{-1.0, 2.0}, {1.0, 2.0}}, ObjectType::door);
  EXPECT_EQ(fit_beams(World(map), {}, beams(2.01), {}).explained, 1.0);
}

TEST(BeamFit, NobodySeesThroughWallsButThingsMayStandBefore) {
  const World world(angled_room().map);
  const auto fit = [&](double range) {
    return fit_beams(world, {1.0, 1.0, 0.0}, {{{0.0, 0.0}, {-1.0, 0.0}, range}}, {});
  };
  EXPECT_GT(fit(0.5).log_likelihood, fit(1.5).log_likelihood + 10.0);
  EXPECT_EQ(fit(0.5).through, 0.0);
  EXPECT_EQ(fit(1.5).through, 1.0);
}

TEST(ChooseBeams, TakesThemFromAllOverTheScanAndLeavesOutliersOut) {
  const Building building = angled_room();
  auto ends = beam_ends(test::sweep(building.scene, test::pico_laser(), {2.0, 1.1, 0.0}));
  ASSERT_EQ(ends.size(), 1000U);
  const auto beams = choose_beams(ends, 100);
  ASSERT_EQ(beams.size(), 100U);
  EXPECT_LT(std::abs(std::atan2(beams.front().direction.y(), beams.front().direction.x()) + 2.0),
            0.03);
  EXPECT_LT(std::abs(std::atan2(beams.back().direction.y(), beams.back().direction.x()) - 2.0),
            0.03);
  for (std::size_t i = 5; i < ends.size(); i += 20) ends[i].location *= 3.0;
  EXPECT_EQ(choose_beams(ends, 100).size(), 50U);
  EXPECT_EQ(choose_beams(ends, 5000).size(), 950U);
  EXPECT_TRUE(choose_beams({}, 100).empty());
}

}  // namespace
}  // namespace perceptor::localize
