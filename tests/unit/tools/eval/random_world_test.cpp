#include "tools/eval/random_world.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "components/bridge/world_file.hpp"
#include "tools/eval/world_writer.hpp"

namespace perceptor {
namespace {

double distance_between(const Segment& s, const Segment& t) {
  return std::min({distance(s, t.a), distance(s, t.b), distance(t, s.a), distance(t, s.b)});
}

std::string text_of(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

class RandomWorldTest : public ::testing::TestWithParam<std::size_t> {
 protected:
  void SetUp() override {
    const std::string test = ::testing::UnitTest::GetInstance()->current_test_info()->name();
    folder_ = std::filesystem::path(::testing::TempDir()) /
              ("random_" + test.substr(0, test.find('/')) + std::to_string(GetParam()));
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  RandomWorldParameters parameters_;
  RandomWorld world_ = draw_random_world(parameters_, GetParam());
  std::filesystem::path folder_;
};

TEST_P(RandomWorldTest, DoorwaysAreAsWideAsTheyShouldBeInWallsOfTheRightThickness) {
  for (const Doorway& doorway : world_.rooms.doorways) {
    const double width = length(doorway.face);
    EXPECT_GE(width, doorway.is_driven ? 0.8 : 0.5);
    EXPECT_LE(width, 1.5);
    const double thickness = distance(doorway.face.a, doorway.other_face.a);
    EXPECT_GE(thickness, 0.1 - 1e-9);
    EXPECT_LE(thickness, 0.2 + 1e-9);
  }
}

TEST_P(RandomWorldTest, TheTourKeepsClearOfWallsAndFurniture) {
  for (const Segment& leg : legs(world_.tour)) {
    for (const Segment& wall : walls(world_.rooms))
      EXPECT_GE(distance_between(leg, wall), parameters_.clearance);
    for (const auto* list : {&world_.cabinets, &world_.boxes})
      for (const Furniture& furniture : *list)
        for (const Segment& side : sides(furniture))
          EXPECT_GE(distance_between(leg, side), parameters_.furniture_gap);
  }
}

TEST_P(RandomWorldTest, SomebodyWalksThere) {
  EXPECT_GE(world_.people.size(), 1U);
  EXPECT_LE(world_.people.size(), 3U);
}

TEST_P(RandomWorldTest, TheSameSeedWritesTheSameFiles) {
  write_random_world(world_, parameters_, GetParam(), folder_ / "a", "w");
  write_random_world(draw_random_world(parameters_, GetParam()), parameters_, GetParam(),
                     folder_ / "b", "w");
  for (const char* file : {"maps/w.json", "worlds/w.json"}) {
    EXPECT_EQ(text_of(folder_ / "a" / file), text_of(folder_ / "b" / file));
    EXPECT_FALSE(text_of(folder_ / "a" / file).empty());
  }
}

TEST_P(RandomWorldTest, TheSimulatorDrivesTheWholeTourWithoutStandingAgainstAnything) {
  write_random_world(world_, parameters_, GetParam(), folder_, "w");
  sim::SimulatorParameters parameters = read_world(folder_ / "worlds" / "w.json", Robot{});
  EXPECT_EQ(parameters.world.doors.size(), world_.rooms.doorways.size());
  parameters.base.footprint = {{0.205, 0.075},  {0.105, 0.175},   {-0.105, 0.175},
                               {-0.205, 0.075}, {-0.205, -0.075}, {-0.105, -0.175},
                               {0.105, -0.175}, {0.205, -0.075}};  // PICO's
  parameters.laser.beams = 1;                                      // nobody looks
  sim::Simulator simulator(parameters);
  const auto stops = static_cast<int>(world_.tour.size());
  const std::int64_t end = simulator.utime() + 400'000'000;
  while (simulator.waypoints_reached() < stops && simulator.utime() < end) {
    simulator.advance();
    ASSERT_FALSE(simulator.truth().in_collision) << simulator.utime();
  }
  EXPECT_EQ(simulator.waypoints_reached(), stops);
}

INSTANTIATE_TEST_SUITE_P(Numbers, RandomWorldTest,
                         ::testing::Range(std::size_t{1}, std::size_t{21}));

TEST(RandomWorld, NoTwoAreAlike) {
  const RandomWorld first = draw_random_world({}, 1);
  const RandomWorld second = draw_random_world({}, 2);
  EXPECT_NE(first.start_in_world, second.start_in_world);
}

}  // namespace
}  // namespace perceptor
