#include "tools/eval/explained_beams.hpp"

#include <gtest/gtest.h>

#include "tests/unit/tools/eval/walls.hpp"

namespace perceptor {
namespace {

/// A beam from the origin that ends at (x, y).
BeamEnd beam_to(double x, double y) {
  return {.location = {x, y}, .origin = Vector2::Zero(), .range = std::hypot(x, y)};
}

/// Two metres ahead, from right to left.
Map wall_ahead() {
  Map map;
  testing::add_wall(map, {{2.0, -1.0}, {2.0, 1.0}});
  return map;
}

TEST(ExplainedBeams, EndOnAWallOrNearIt) {
  const Share share = explained_beams({beam_to(2.04, 0.5), beam_to(1.96, -0.5), beam_to(2.06, 0.0),
                                       beam_to(2.0, 1.04), beam_to(2.0, 1.06)},
                                      wall_ahead(), {}, {.max_range = 5.0, .reach = 0.05});
  EXPECT_EQ(share.part, 3);
  EXPECT_EQ(share.whole, 5);
  EXPECT_DOUBLE_EQ(value(share), 0.6);
}

TEST(ExplainedBeams, LongOnesAreNotCounted) {
  const Share share =
      explained_beams({beam_to(2.0, 0.0), beam_to(3.0, 0.0)}, wall_ahead(), {}, {.max_range = 3.0});
  EXPECT_EQ(share.part, 1);
  EXPECT_EQ(share.whole, 1);
}

TEST(ExplainedBeams, OnlyWallsExplain) {
  Map map = wall_ahead();
  map.objects.front().type = ObjectType::door;
  EXPECT_EQ(explained_beams({beam_to(2.0, 0.0)}, map, {}, {}).part, 0);
}

TEST(ExplainedBeams, ThoseOnTheRobotItselfAreNotCounted) {
  Map map = wall_ahead();
  Object robot;
  robot.type = ObjectType::robot;
  for (const Vector2& corner : {Vector2(-0.3, -0.3), Vector2(0.3, -0.3), Vector2(0.0, 0.3)})
    robot.points.push_back(add_point(map, corner));
  map.objects.push_back(robot);
  const std::vector<Vector2> outline = robot_outline(map);
  EXPECT_EQ(outline.size(), 3U);
  EXPECT_EQ(explained_beams({beam_to(0.1, -0.1), beam_to(2.0, 0.0)}, map, outline, {}).whole, 1);
}

TEST(ExplainedBeams, NothingIsAShareOfNothing) {
  EXPECT_EQ(value(explained_beams({}, wall_ahead(), {}, {})), 0.0);
  EXPECT_TRUE(robot_outline(wall_ahead()).empty());
}

}  // namespace
}  // namespace perceptor
