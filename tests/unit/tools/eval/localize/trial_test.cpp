#include "tools/eval/localize/trial.hpp"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

namespace perceptor {
namespace {

std::vector<Site> sites() {
  const std::filesystem::path maps = std::filesystem::path(PERCEPTOR_SOURCE_DIR) / "config/maps";
  return {read_site(maps / "hospital.json"), read_site(maps / "escape_room.json")};
}

TEST(Trial, SeedAndNumberSayAll) {
  const std::vector<Site> all = sites();
  const Trial first = draw_trial(all, {}, {}, 3);
  const Trial second = draw_trial(all, {}, {}, 3);
  EXPECT_EQ(first.site, second.site);
  EXPECT_EQ(first.simulator.seed, second.simulator.seed);
  EXPECT_EQ(first.simulator.start_in_world, second.simulator.start_in_world);
  EXPECT_EQ(first.simulator.world.boxes.size(), second.simulator.world.boxes.size());
  EXPECT_NE(first.simulator.seed, draw_trial(all, {}, {}, 4).simulator.seed);
}

TEST(Trial, EveryConditionIsDrawn) {
  const std::vector<Site> all = sites();
  std::set<double> clutter;
  std::set<Doors> doors;
  int kidnapped = 0;
  for (std::size_t number = 1; number <= 40; ++number) {
    const Trial trial = draw_trial(all, {}, {}, number);
    const sim::SimulatorParameters& simulator = trial.simulator;
    clutter.insert(trial.conditions.clutter);
    doors.insert(trial.conditions.doors);
    kidnapped += trial.kidnapped_to ? 1 : 0;
    EXPECT_EQ(simulator.world.boxes.empty(), trial.conditions.clutter == 0.0);
    EXPECT_GE(simulator.tour.points.size(), 2U);
    const Vector2 start = simulator.start_in_world.location();
    for (const Segment& wall : simulator.world.walls) EXPECT_GT(distance(wall, start), 0.35);
    for (const Segment& wall : lines(all[trial.site].plan)) {
      const auto nearest = std::ranges::min_element(
          simulator.world.walls, {}, [&](const Segment& real) { return distance(real.a, wall.a); });
      EXPECT_LE(distance(nearest->a, wall.a), trial.conditions.displaced + 1e-9);
    }
  }
  EXPECT_EQ(clutter.size(), 3U);
  EXPECT_EQ(doors.size(), 3U);
  EXPECT_GT(kidnapped, 0);
  EXPECT_LT(kidnapped, 40);
}

TEST(Leaves, FlushOnBothSidesOfAThickWall) {
  const localize::Doorway doorway{{{0.0, 0.0}, {1.0, 0.0}}, 0.1};
  const std::vector<Segment> flush = flush_leaves(doorway);
  ASSERT_EQ(flush.size(), 2U);
  EXPECT_DOUBLE_EQ(flush[0].a.y(), 0.1);
  EXPECT_DOUBLE_EQ(flush[1].a.y(), -0.1);
  EXPECT_DOUBLE_EQ(recessed_leaf(doorway, 0.08).a.y(), 0.0);
  EXPECT_EQ(flush_leaves({doorway.opening, 0.0}).size(), 1U);
  EXPECT_DOUBLE_EQ(recessed_leaf({doorway.opening, 0.0}, 0.08).a.y(), 0.08);
}

}  // namespace
}  // namespace perceptor
