#include "tools/eval/localize/oracle.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "components/bridge/sim/laser.hpp"

namespace perceptor {
namespace {

std::vector<Segment> closed(const std::vector<Vector2>& corners) {
  std::vector<Segment> walls;
  for (std::size_t i = 0; i < corners.size(); ++i)
    walls.push_back({corners[i], corners[(i + 1) % corners.size()]});
  return walls;
}

localize::World world_of(const std::vector<Segment>& walls) {
  Map map;
  for (const Segment& wall : walls) {
    const Index index = add_segment(map, wall, ObjectType::wall);
    map.objects[static_cast<std::size_t>(index)].free_side = FreeSide::left;
  }
  return localize::World(map);
}

/// What a robot that turns in place sees all around.
std::vector<TrueView> views(const std::vector<Segment>& walls, const Position& robot) {
  TrueView view{0.0, robot, {}};
  for (int k = 0; k < 72; ++k) {
    const double bearing = 2.0 * std::numbers::pi * (k + 0.5) / 72.0;
    view.beams.push_back({{0.0, 0.0},
                          {std::cos(bearing), std::sin(bearing)},
                          sim::cast_ray(robot.location(), robot.a + bearing, {walls, {}, {}})});
  }
  return {view, view};
}

TEST(Oracle, PlainRoomLooksTheSameFromItsOtherEnd) {
  const auto walls = closed({{0.0, 0.0}, {4.0, 0.0}, {4.0, 3.0}, {0.0, 3.0}});
  const auto other = elsewhere(world_of(walls), views(walls, {1.0, 1.0, 0.3}));
  ASSERT_TRUE(other);
  EXPECT_LT(distance(other->location(), Vector2(3.0, 2.0)), 0.15);
}

TEST(Oracle, AngledRoomDoesNot) {
  const auto walls =
      closed({{0.0, 0.0}, {5.0, 0.0}, {5.0, 2.0}, {3.0, 2.0}, {3.0, 4.0}, {0.0, 4.0}});
  EXPECT_FALSE(elsewhere(world_of(walls), views(walls, {1.2, 2.9, -1.0})));
}

TEST(Oracle, ABoxInOneCornerTellsNothing) {
  // Unknown to the map: as a thing of the other end it would be as new.
  const auto walls = closed({{0.0, 0.0}, {4.0, 0.0}, {4.0, 3.0}, {0.0, 3.0}});
  std::vector<Segment> seen = walls;
  for (const Segment& side : closed({{2.0, 0.2}, {2.4, 0.2}, {2.4, 0.6}, {2.0, 0.6}}))
    seen.push_back(side);
  EXPECT_TRUE(elsewhere(world_of(walls), views(seen, {1.0, 1.0, 0.3})));
}

TEST(Oracle, NothingSeenIsNowhereElse) {
  EXPECT_FALSE(elsewhere(world_of(closed({{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}})), {}));
}

}  // namespace
}  // namespace perceptor
