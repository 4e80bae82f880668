#include "components/merge/forgetting.hpp"

#include <gtest/gtest.h>

#include "tests/unit/components/merge/scene.hpp"

namespace perceptor::merge {
namespace {

// Robot at (2, 1.5): a cupboard stands before the far wall, or does not.
const std::vector<Drawn> kFarWall = {wall(4, 3, 0, 3)};
const std::vector<Drawn> kCupboard = {wall(2.5, 2.4, 1.5, 2.4), wall(4, 3, 2.9, 3),
                                      wall(1.1, 3, 0, 3)};

bool has_wall_at(const LocalMap& local, double y, double x) {
  const Map map = in_local(local);
  for (const Object& object : map.objects)
    if (distance(segment(map, object), {x, y}) < 0.02) return true;
  return false;
}

TEST(Forgetting, TentativeWallThatIsNotSeenAgainIsRemoved) {
  Session session;
  session.see_often({wall(0, 0, 4, 0)}, 5);
  session.see({wall(0, 0, 4, 0), wall(1, 3, 0, 3)});
  EXPECT_EQ(session.walls().size(), 2U);
  session.see_often({wall(0, 0, 4, 0)}, 2);  // half a second
  EXPECT_EQ(session.walls().size(), 2U);
  session.see({wall(0, 0, 4, 0)});
  EXPECT_EQ(session.walls().size(), 1U);
}

TEST(Forgetting, ErrorThatComesNowAndThenIsNeverConfirmed) {
  // Once in a second, always in the same place, for a minute.
  Session session;
  session.see_often({wall(0, 0, 4, 0)}, 5);
  for (int i = 0; i < 60; ++i) {
    session.see({wall(0, 0, 4, 0), wall(1, 3, 0, 3)});
    EXPECT_EQ(session.see_often({wall(0, 0, 4, 0)}, 3).walls.objects.size(), 1U);
  }
}

TEST(Forgetting, ErrorOfEachThirdScanIsNeverConfirmed) {
  MergeParameters parameters;
  parameters.confirmation.tentative_time = 10.0;
  Session session(parameters);
  session.see_often({wall(0, 0, 4, 0)}, 5);
  for (int i = 0; i < 20; ++i) {
    session.see({wall(0, 0, 4, 0), wall(1, 3, 0, 3)});
    EXPECT_EQ(session.see_often({wall(0, 0, 4, 0)}, 2).walls.objects.size(), 1U);
  }
}

TEST(Forgetting, TentativeWallThatIsSeenThroughGoesAtOnce) {
  Session session;
  session.see_often(kCupboard, 2);
  ASSERT_EQ(session.walls().size(), 3U);
  session.see(kFarWall);
  for (const Wall& left : session.walls()) EXPECT_GT(left.segment.a.y(), 2.9);
}

TEST(Forgetting, TentativeWallConnectedToAConfirmedOneIsConfirmed) {
  Session session;
  session.see_often({wall(0, 0, 4, 0)}, 3);
  // A chain: the second new wall is connected through the first. Two scans are enough for both,
  // but not before half a second.
  const std::vector<Drawn> chain = {wall(0, 0, 4, 0), wall(4, 0, 4, 3), wall(4, 3, 0, 3)};
  EXPECT_EQ(session.see(chain).walls.objects.size(), 1U);
  session.wait(0.25);
  EXPECT_EQ(session.see(chain).walls.objects.size(), 3U);
}

TEST(Forgetting, LoneCorridorWallSurvives) {
  Session session;
  session.see_often({wall(-5, 0, 5, 0)}, 3);
  session.wait(3600.0);
  EXPECT_EQ(session.see({}).walls.objects.size(), 1U);
}

TEST(Forgetting, WallOutOfSightStays) {
  Session session;
  session.see_often(room(), 5);
  const LocalMap local = session.see_often({wall(0, 0, 4, 0)}, 100);
  EXPECT_EQ(local.walls.objects.size(), 4U);
}

TEST(Forgetting, WallInViewThatGivesNoReturnStays) {
  // Nothing comes back from where the cupboard stood: unknown, not free.
  Session session;
  session.see_often(kCupboard, 10);
  const LocalMap local = session.see_often({wall(4, 3, 2.9, 3), wall(1.1, 3, 0, 3)}, 100);
  EXPECT_TRUE(has_wall_at(local, 2.4, 2.0));
}

TEST(Forgetting, SeenThroughWallGoes) {
  Session session;
  EXPECT_TRUE(has_wall_at(session.see_often(kCupboard, 100), 2.4, 2.0));
  // One scan is not enough, half a second at 10 Hz is.
  EXPECT_TRUE(has_wall_at(session.see(kFarWall), 2.4, 2.0));
  EXPECT_FALSE(has_wall_at(session.see_often(kFarWall, 5), 2.4, 2.0));
}

TEST(Forgetting, LightWallGoesSooner) {
  Session session;
  session.see_often(kCupboard, 3);
  EXPECT_FALSE(has_wall_at(session.see_often(kFarWall, 2), 2.4, 2.0));
}

TEST(Forgetting, OneScanThroughAWallIsMadeUpForBySightings) {
  Session session;
  session.see_often(kCupboard, 100);
  for (int i = 0; i < 10; ++i) {
    session.see(kFarWall);
    session.see_often(kCupboard, 20);
  }
  EXPECT_TRUE(has_wall_at(session.see(kCupboard), 2.4, 2.0));
}

TEST(Forgetting, DoorThatOpensIsCutOutOfItsWall) {
  // A shut door flush with its wall, then open, with a wall seen behind.
  Session session;
  session.see_often({wall(4, 3, 0, 3)}, 40);
  const std::vector<Drawn> open = {wall(4, 3, 2.5, 3, CornerMethod::none, CornerMethod::spike),
                                   wall(1.5, 3, 0, 3, CornerMethod::spike, CornerMethod::none),
                                   wall(3, 5, 1, 5)};
  const LocalMap local = session.see_often(open, 10);
  EXPECT_EQ(local.walls.objects.size(), 3U);
  EXPECT_FALSE(has_wall_at(local, 3.0, 2.0));
  const Map map = in_local(local);
  std::vector<double> jambs;
  for (const Point& point : map.points)
    if (point.method == CornerMethod::spike) jambs.push_back(point.location.x());
  std::sort(jambs.begin(), jambs.end());
  ASSERT_EQ(jambs.size(), 2U);
  EXPECT_NEAR(jambs[0], 1.5, 1e-3);
  EXPECT_NEAR(jambs[1], 2.5, 1e-3);
}

TEST(Forgetting, WallThatShrinksToNothingGoes) {
  std::vector<Wall> walls(2);
  walls[0].segment = {{0.0, 0.0}, {0.04, 0.0}};
  walls[1].segment = {{0.0, 1.0}, {0.06, 1.0}};
  forget_short(walls, 0.05);
  ASSERT_EQ(walls.size(), 1U);
  EXPECT_DOUBLE_EQ(walls[0].segment.a.y(), 1.0);
}

TEST(Forgetting, LongestUnseenGoesFirstWhenThereAreTooMany) {
  MergeParameters parameters;
  parameters.max_walls = 3;
  Session session(parameters);
  session.see_often({wall(0, 0, 1, 0)}, 3);
  session.see_often({wall(2, 0, 3, 0)}, 3);
  session.see_often({wall(4, 0, 5, 0), wall(6, 0, 7, 0)}, 3);
  ASSERT_EQ(session.walls().size(), 3U);
  EXPECT_NEAR(session.walls()[0].segment.a.x(), 2.0, 1e-9);
}

TEST(Forgetting, TooManyWallsAtOnceAreBounded) {
  MergeParameters parameters;
  parameters.max_walls = 5;
  Session session(parameters);
  std::vector<Drawn> many;
  for (int i = 0; i < 40; ++i) many.push_back(wall(i, 0, i + 0.5, 0));
  session.see_often(many, 5);
  EXPECT_EQ(session.walls().size(), 5U);
}

}  // namespace
}  // namespace perceptor::merge
