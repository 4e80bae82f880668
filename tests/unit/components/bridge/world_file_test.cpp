#include "components/bridge/world_file.hpp"

#include <filesystem>
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace perceptor {
namespace {

const std::filesystem::path config_dir = PERCEPTOR_TEST_CONFIG;

/// A folder with a map of one room and one door, and a world file.
class WorldFile : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(testing::TempDir()) / (std::string("world_") + test->name());
    std::filesystem::create_directories(folder_);
    write("room.json", R"({
      "points": [{"x": 0, "y": 0}, {"x": 4, "y": 0}, {"x": 4, "y": 1}, {"x": 4, "y": 2},
                 {"x": 4, "y": 3}, {"x": 0, "y": 3}, {"x": 1, "y": 1}, {"x": 1, "y": 2}],
      "walls": [[0, 1], [1, 2], [3, 4], [4, 5], [5, 0]],
      "cabinets": [[[6, 7]]],
      "doors": [[[2, 3]]]})");
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
  }
  sim::SimulatorParameters read(const std::string& text) const {
    write("world.json", text);
    return read_world(folder_ / "world.json", Robot{});
  }
  /// The message of the error that reading gives.
  std::string fault(const std::string& text) const {
    try {
      read(text);
    } catch (const config::Error& error) {
      return error.what();
    }
    return {};
  }

  std::filesystem::path folder_;
};

TEST_F(WorldFile, TakesWallsCabinetsAndDoorsFromTheMap) {
  const auto parameters = read(R"({"map": "room.json"})");
  EXPECT_EQ(parameters.world.walls.size(), 5U);
  EXPECT_EQ(parameters.world.cabinets.size(), 1U);
  ASSERT_EQ(parameters.world.doors.size(), 1U);
  EXPECT_EQ(parameters.world.doors[0].mode, sim::DoorMode::open);
  EXPECT_EQ(parameters.world.doors[0].opening.b, Vector2(4.0, 2.0));
}

TEST_F(WorldFile, TakesTheRobotsLaserAndLimitsWhereItSaysNothing) {
  Robot robot;
  robot.laser.range_sigma = 0.03;
  robot.laser.valid_max = 8.0;
  robot.limits.speed = 0.7;
  write("world.json", R"({"map": "room.json"})");
  const auto parameters = read_world(folder_ / "world.json", robot);
  EXPECT_EQ(parameters.laser.noise_sigma, 0.03);
  EXPECT_EQ(parameters.laser.valid_max, 8.0);
  EXPECT_GT(parameters.laser.range_max, 8.0);
  EXPECT_EQ(parameters.base.speed, 0.7);
  EXPECT_EQ(parameters.base.footprint.size(), 8U);
}

TEST_F(WorldFile, ReadsWhatItAdds) {
  const auto parameters = read(R"({
    "map": "room.json", "seed": 12, "start": {"x": 2, "y": 1, "a": 0.5},
    "laser": {"beams": 500, "missed_value": "zero"},
    "doors": [{"door": 0, "state": "on_request", "open_for": 7}],
    "boxes": [{"x": 3, "y": 2.5, "a": 0.1, "length": 0.3, "width": 0.2}],
    "people": [{"path": [{"x": 2, "y": 2}, {"x": 3, "y": 2}]}],
    "tour": [{"x": 3, "y": 1.5, "turn": 1, "pause": 2, "open_door": 0}]})");
  EXPECT_EQ(parameters.seed, 12);
  EXPECT_EQ(parameters.start_in_world, (Position{2.0, 1.0, 0.5}));
  EXPECT_EQ(parameters.laser.beams, 500);
  EXPECT_EQ(parameters.laser.missed_value, sim::MissedValue::zero);
  EXPECT_EQ(parameters.world.doors[0].mode, sim::DoorMode::on_request);
  EXPECT_EQ(parameters.world.doors[0].open_for, 7.0);
  EXPECT_EQ(parameters.world.doors[0].opening.a, Vector2(4.0, 1.0));
  ASSERT_EQ(parameters.world.boxes.size(), 1U);
  ASSERT_EQ(parameters.world.people.size(), 1U);
  EXPECT_EQ(parameters.world.people[0].path.size(), 2U);
  ASSERT_EQ(parameters.tour.points.size(), 1U);
  EXPECT_EQ(parameters.tour.points[0].location, Vector2(3.0, 1.5));
  EXPECT_EQ(parameters.tour.points[0].open_door, 0);
}

TEST_F(WorldFile, SaysWhatIsWrong) {
  using testing::HasSubstr;
  EXPECT_THAT(fault(R"({"map": "room.json", "sed": 1})"), HasSubstr("seed"));
  EXPECT_THAT(fault(R"({"map": "none.json"})"), HasSubstr("none.json"));
  EXPECT_THAT(fault(R"({"map": "room.json", "doors": [{"door": 1}]})"), HasSubstr("/doors/0/door"));
  EXPECT_THAT(fault(R"({"map": "room.json", "tour": [{"x": 1, "y": 1, "open_door": 3}]})"),
              HasSubstr("/tour/0/open_door"));
  EXPECT_THAT(fault(R"({"map": "room.json", "people": [{}]})"), HasSubstr("path"));
  EXPECT_THAT(fault(R"({"map": "room.json", "laser": {"sweep_time": 0.03}})"),
              HasSubstr("sweep_time"));
  EXPECT_THAT(fault(R"({"map": "room.json", "laser": {"angle_min": 3}})"), HasSubstr("angle_max"));
}

TEST(FindWorld, FindsByNameAndByFile) {
  EXPECT_EQ(find_world("hospital", config_dir), config_dir / "worlds" / "hospital.json");
  EXPECT_EQ(find_world("office.json", config_dir), config_dir / "worlds" / "office.json");
  const std::string file = (config_dir / "worlds" / "office.json").string();
  EXPECT_EQ(find_world(file, "nowhere"), file);
}

TEST(FindWorld, ListsTheWorldsThereAre) {
  try {
    find_world("hopsital", config_dir);
    FAIL() << "found a world that is not there";
  } catch (const config::Error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("escape_room, hospital, hospital_hard, office"));
  }
}

/// A world that comes with the project, and how long its tour takes at most [s].
struct OwnWorld {
  const char* name;
  double seconds;
};

class OwnWorlds : public testing::TestWithParam<OwnWorld> {};

/// Crosses, or lies in, a wall, a cabinet or a box.
bool stands_in_something(const sim::SimulatorParameters& parameters,
                         const Position& robot_in_world) {
  const sim::Polygon robot = sim::transform(robot_in_world, parameters.base.footprint);
  for (const Segment& wall : parameters.world.walls)
    if (sim::touches(robot, wall)) return true;
  for (const Segment& edge : parameters.world.cabinets)
    if (sim::touches(robot, edge)) return true;
  for (const sim::Box& box : parameters.world.boxes)
    for (const Segment& edge : edges(sim::outline(box)))
      if (sim::touches(robot, edge)) return true;
  return false;
}

TEST_P(OwnWorlds, TourReachesEveryWaypointAndTouchesNothing) {
  sim::SimulatorParameters parameters =
      read_world(find_world(GetParam().name, config_dir), Robot{});
  parameters.laser.beams = 1;  // not looked at here
  sim::Simulator simulator(parameters);
  const auto waypoints = static_cast<int>(parameters.tour.points.size());
  const int rounds = parameters.tour.loop ? 3 : 1;
  const auto end = static_cast<std::int64_t>(GetParam().seconds * 1e6) * rounds;
  while (simulator.waypoints_reached() < rounds * waypoints && simulator.utime() < end) {
    simulator.advance();
    ASSERT_FALSE(simulator.truth().in_collision) << "after " << simulator.waypoints_reached();
    ASSERT_FALSE(stands_in_something(parameters, simulator.truth().robot_in_world));
  }
  EXPECT_EQ(simulator.waypoints_reached(), rounds * waypoints);
}

INSTANTIATE_TEST_SUITE_P(Tours, OwnWorlds,
                         testing::Values(OwnWorld{"escape_room", 40.0}, OwnWorld{"office", 90.0},
                                         OwnWorld{"hospital", 180.0},
                                         OwnWorld{"hospital_hard", 240.0}),
                         [](const auto& tested) { return std::string(tested.param.name); });

TEST(OwnWorlds, TourOfTheHospitalLastsNinetySecondsAtLeast) {
  sim::SimulatorParameters parameters = read_world(find_world("hospital", config_dir), Robot{});
  parameters.laser.beams = 1;
  sim::Simulator simulator(parameters);
  while (simulator.utime() - parameters.start_utime < 90'000'000) simulator.advance();
  EXPECT_LT(simulator.waypoints_reached(), static_cast<int>(parameters.tour.points.size()));
}

}  // namespace
}  // namespace perceptor
