/// The whole chain, by tools/run, on a robot that speaks ROS 1: what it finds of a world is what it
/// finds on the simulator.
#include <algorithm>
#include <array>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iostream>

#include <gtest/gtest.h>
#include <pico/map_t.hpp>

#include "common/bus/bus.hpp"
#include "common/bus/channels.hpp"
#include "common/geometry/segment.hpp"
#include "tests/process/ros_fixture.hpp"

namespace perceptor::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSeconds = "20";  // of robot time
/// [m] Asked of walls, corners and doors.
constexpr double kWithin = 0.01;
/// Maps in which all must be the same.
constexpr double kShare = 0.99;

/// By the simulated time of their scan [us].
using Maps = std::map<std::int64_t, pico::map_t>;

Maps identified_maps(const fs::path& log, std::int64_t base) {
  Maps maps;
  LogReader reader(log);
  while (const auto event = reader.next()) {
    if (event->channel != channel::identified_map) continue;
    pico::map_t map;
    EXPECT_EQ(detail::decode(event->data, map), "");
    maps[map.utime - base] = map;
  }
  return maps;
}

/// What is compared: lines by their two ends, corners by their place twice.
std::vector<Segment> lines_of(const pico::map_t& map, std::int8_t type) {
  std::vector<Segment> lines;
  for (const pico::map_object_t& object : map.objects) {
    if (object.type != type) continue;
    const auto& a = map.points.at(static_cast<std::size_t>(object.points.at(0)));
    const auto& b = map.points.at(static_cast<std::size_t>(object.points.at(1)));
    lines.push_back({{a.x, a.y}, {b.x, b.y}});
  }
  return lines;
}
std::vector<Segment> corners_of(const pico::map_t& map, std::int8_t property) {
  std::vector<Segment> corners;
  for (const pico::map_point_t& point : map.points)
    if (point.property == property) corners.push_back({{point.x, point.y}, {point.x, point.y}});
  return corners;
}

double distance_of_ends(const Segment& p, const Segment& q) {
  return std::min(std::max((p.a - q.a).norm(), (p.b - q.b).norm()),
                  std::max((p.a - q.b).norm(), (p.b - q.a).norm()));
}

bool are_same(const std::vector<Segment>& ones, const std::vector<Segment>& others) {
  return ones.size() == others.size() && std::ranges::all_of(ones, [&](const Segment& one) {
           return std::ranges::any_of(others, [&](const Segment& other) {
             return distance_of_ends(one, other) < kWithin;
           });
         });
}

bool are_same(const pico::map_t& one, const pico::map_t& other) {
  constexpr std::array types{pico::map_object_t::WALL, pico::map_object_t::DOOR,
                             pico::map_object_t::POSSIBLE_DOOR};
  constexpr std::array properties{pico::map_point_t::CONVEX, pico::map_point_t::CONCAVE};
  return std::ranges::all_of(types,
                             [&](std::int8_t type) {
                               return are_same(lines_of(one, type), lines_of(other, type));
                             }) &&
         std::ranges::all_of(properties, [&](std::int8_t property) {
           return are_same(corners_of(one, property), corners_of(other, property));
         });
}

class RosChain : public RosFixture {
 protected:
  void SetUp() override {
    RosFixture::SetUp();
    setenv("PERCEPTOR_PRIVATE_BUS", "1", 1);  // built already, and on a bus of our own
    setenv("PERCEPTOR_BIN", program(".").c_str(), 1);
  }

  static Finished run_chain(const std::vector<std::string>& options, const fs::path& log) {
    std::vector<std::string> command{source("tools/run"), "--duration", kSeconds, "--record", log};
    command.insert(command.end(), options.begin(), options.end());
    return run(command, Seconds(90));
  }

  /// The maps, of the robot that measures what the simulator of pico-bridge would.
  Maps on_the_robot() {
    start_master();
    start_robot({"--model", "ours", "--miss", "infinity", "--wait"});
    const Finished finished =
        run_chain({"--source", "ros", "--map", "hospital"}, scratch_ / "ros.lcmlog");
    said_ = finished.output;
    std::string word;
    std::int64_t base = 0;
    std::ifstream(scratch_ / "journal") >> word >> base;
    return identified_maps(scratch_ / "ros.lcmlog", base / 1000);
  }
  Maps on_the_simulator() {
    said_ = run_chain({"--world", "hospital"}, scratch_ / "sim.lcmlog").output;
    return identified_maps(scratch_ / "sim.lcmlog", 0);
  }

  std::string said_;
};

TEST_F(RosChain, FindsTheSameWallsCornersAndDoorsAsOnTheSimulator) {
  const Maps robot = on_the_robot();
  ASSERT_GT(robot.size(), 400U) << said_;
  const Maps simulator = on_the_simulator();
  ASSERT_GT(simulator.size(), 400U) << said_;
  std::size_t compared = 0;
  std::size_t same = 0;
  std::size_t doors = 0;
  for (const auto& [utime, map] : robot) {
    const auto other = simulator.find(utime);
    if (other == simulator.end()) continue;  // the logger lost one of the two
    ++compared;
    same += are_same(map, other->second) ? 1 : 0;
    doors += lines_of(map, pico::map_object_t::DOOR).size();
  }
  std::cout << same << " of " << compared << " maps are the same within " << kWithin << " m, with "
            << doors << " doors\n";
  EXPECT_GT(compared, 400U);
  EXPECT_GT(doors, 100U);
  EXPECT_GE(static_cast<double>(same), kShare * static_cast<double>(compared));
}

}  // namespace
}  // namespace perceptor::test
