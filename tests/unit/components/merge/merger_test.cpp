#include "components/merge/merger.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "tests/unit/components/merge/scene.hpp"

namespace perceptor::merge {
namespace {

constexpr double kExact = 1e-9;  // rounding only

const Position kRobot{2.0, 1.5, 0.3};

/// The only published wall, in the local frame.
Segment only_wall(const LocalMap& local) {
  const Map map = in_local(local);
  EXPECT_EQ(map.objects.size(), 1U);
  return map.objects.empty() ? Segment{} : segment(map, map.objects.front());
}

TEST(Merger, FirstScanOfARoomIsTentative) {
  Session session;
  EXPECT_TRUE(session.see(room()).walls.objects.empty());
  EXPECT_EQ(session.walls().size(), 4U);
}

TEST(Merger, WallIsConfirmedWhenItIsSeenAgain) {
  Session session;
  EXPECT_EQ(session.see_often(room(), 2).walls.objects.size(), 0U);
  const LocalMap third = session.see(room());
  EXPECT_EQ(third.walls.objects.size(), 4U);
  EXPECT_TRUE(third.walls.objects.front().is_new);
  EXPECT_FALSE(session.see(room()).walls.objects.front().is_new);
}

TEST(Merger, NoWallIsConfirmedWithinHalfASecond) {
  Session session;
  const double at_40_hz = 0.025 - kScanPeriod * 1e-6;
  for (int i = 0; i < 20; ++i) {
    EXPECT_EQ(session.see(room()).walls.objects.size(), 0U);
    session.wait(at_40_hz);
  }
  EXPECT_EQ(session.see(room()).walls.objects.size(), 4U);
}

/// Scans at 40 Hz of one wall, and of a piece of 0.3 m that moves along its own line.
void see_walking(Session& session, double speed, CornerMethod ends, std::size_t most_walls) {
  constexpr double kPeriod = 0.025;
  const double along = 4.0;
  const int scans = static_cast<int>(along / speed / kPeriod);
  for (int i = 0; i < scans; ++i) {
    const double x = 4.0 - speed * kPeriod * i;
    const LocalMap local = session.see({wall(0, 0, 4, 0), wall(x, 3, x - 0.3, 3, ends, ends)});
    EXPECT_LE(local.walls.objects.size(), most_walls) << "at " << x;
    session.wait(kPeriod - kScanPeriod * 1e-6);
  }
}

TEST(Merger, WalkingLegNeverBecomesAWall) {
  // Nothing is seen behind it that would take its trail out again.
  for (const double speed : {0.5, 0.8, 1.4, 3.0}) {
    Session session;
    see_walking(session, speed, CornerMethod::spike, 1);
    for (const Wall& left : session.walls()) {
      const double longest = left.confirmed ? 4.0 + kExact : 0.6;
      EXPECT_LT(length(left.segment), longest) << "at " << speed;
    }
  }
}

TEST(Merger, WallSeenPieceByPieceThroughADoorwayGrows) {
  // The same piece, but its ends are cut by what stands before it.
  Session session;
  see_walking(session, 0.8, CornerMethod::none, 2);
  const Map map = in_local(session.see({}));
  ASSERT_EQ(map.objects.size(), 2U);
  EXPECT_NEAR(length(segment(map, 1)), 4.3, 0.05);
}

TEST(Merger, CabinetSeenToEndBeforeAWallIsNotJoinedToIt) {
  // Its side ends 0.15 m before the wall, and the beam beside that end goes on to the wall.
  Session session;
  const std::vector<Drawn> cabinet = {
      wall(1, 0, 4, 0), wall(1, 0.6, 1, 0.15, CornerMethod::none, CornerMethod::spike)};
  const Map map = in_local(session.see_often(cabinet, 10));
  ASSERT_EQ(map.objects.size(), 2U);
  EXPECT_NEAR(segment(map, 1).b.y(), 0.15, kExact);
}

TEST(Merger, CabinetJoinedToAWallIsTakenOffItWhenItsEndIsSeen) {
  Session session;
  session.see_often({wall(1, 0, 4, 0), wall(1, 0.6, 1, 0.15)}, 10);
  ASSERT_NE(session.walls()[1].ends[kHead].connected, kNone);
  session.see({wall(1, 0, 4, 0), wall(1, 0.6, 1, 0.15, CornerMethod::none, CornerMethod::spike)});
  EXPECT_EQ(session.walls()[1].ends[kHead].connected, kNone);
  EXPECT_NEAR(session.walls()[1].segment.b.y(), 0.15, kExact);
}

TEST(Merger, EmptyScanPublishesTheMapAgain) {
  Session session;
  session.see_often(room(), 3);
  const LocalMap again = session.see({});
  EXPECT_EQ(again.walls.objects.size(), 4U);
  EXPECT_EQ(again.registered, 0);
}

TEST(Merger, PublishedWallsAreInTheRobotFrame) {
  Session session;
  const LocalMap local = session.see_often(room(), 3);
  const Segment first = segment(local.walls, local.walls.objects.front());
  const Segment expected = transform(inverse(kRobot), Segment{{0.0, 0.0}, {4.0, 0.0}});
  EXPECT_NEAR(distance(first.a, expected.a), 0.0, kExact);
  EXPECT_NEAR(distance(first.b, expected.b), 0.0, kExact);
  EXPECT_EQ(find_broken_reference(local.walls), "");
}

TEST(Merger, MergesTwoHalvesOfOneWall) {
  Session session;
  const LocalMap local = session.see_often({wall(0, 0, 1.9, 0), wall(2.1, 0, 4, 0)}, 3);
  EXPECT_NEAR(length(only_wall(local)), 4.0, kExact);
}

TEST(Merger, JoinsTwoPiecesWhenTheWallBetweenIsSeen) {
  Session session;
  EXPECT_EQ(session.see_often({wall(0, 0, 1, 0), wall(3, 0, 4, 0)}, 3).walls.objects.size(), 2U);
  EXPECT_NEAR(length(only_wall(session.see({wall(0.5, 0, 3.5, 0)}))), 4.0, kExact);
}

TEST(Merger, AbsorbsANestedWall) {
  Session session;
  session.see_often({wall(0, 0, 4, 0)}, 3);
  EXPECT_NEAR(length(only_wall(session.see({wall(1, 0.01, 2, 0.01)}))), 4.0, 1e-3);
}

TEST(Merger, AbsorbsAShortWallBesideALongOne) {
  Session session;
  const LocalMap local = session.see_often({wall(0, 0, 4, 0), wall(1, 0.03, 1.2, 0.03)}, 3);
  EXPECT_NEAR(length(only_wall(local)), 4.0, 1e-3);
}

TEST(Merger, ParallelWallsApartStayTwo) {
  Session session;
  const LocalMap local = session.see_often({wall(0, 0, 2, 0), wall(2, 0.3, 4, 0.3)}, 10);
  EXPECT_EQ(local.walls.objects.size(), 2U);
}

TEST(Merger, OppositeFacesOfAThinWallStayTwo) {
  // A partition of 5 cm; the robot sees one face, drives around its end, and sees the other.
  Session session;
  session.see_often({wall(0, 0, 2, 0)}, 5, {1.0, 1.0, 0.0});
  session.see_often({}, 1, {3.0, 0.0, 0.0});
  const LocalMap local = session.see_often({wall(2, -0.05, 0, -0.05)}, 5, {1.0, -1.0, 0.0});
  const Map map = in_local(local);
  ASSERT_EQ(map.objects.size(), 2U);
  EXPECT_NEAR(segment(map, 0).a.y(), 0.0, 1e-3);
  EXPECT_NEAR(segment(map, 1).a.y(), -0.05, 1e-3);
  for (const Point& point : map.points) EXPECT_EQ(point.connected, kNone);
}

TEST(Merger, WallsAcrossADoorwayStayTwo) {
  // In line, 0.8 m apart, with a wall seen behind the opening.
  Session session;
  const std::vector<Drawn> doorway = {wall(0, 0, 1.6, 0), wall(2.4, 0, 4, 0),
                                      wall(1.5, -2, 2.5, -2)};
  EXPECT_EQ(session.see_often(doorway, 10).walls.objects.size(), 3U);
}

TEST(Merger, PiecesInLineDoNotMeetOverTheOpeningBetweenThem) {
  // The ends would reach each other (0.2 m each), but nothing was seen between them.
  Session session;
  session.see_often({wall(0, 0, 2.0, 0), wall(2.37, 0, 4, 0)}, 5);
  ASSERT_EQ(session.walls().size(), 2U);
  EXPECT_NEAR(session.walls()[0].segment.b.x(), 2.0, 0.01);
  EXPECT_NEAR(session.walls()[1].segment.a.x(), 2.37, 0.01);
  for (const Wall& piece : session.walls())
    for (const WallEnd& end : piece.ends) EXPECT_EQ(end.connected, kNone);
}

TEST(Merger, NarrowGapIsADoorwayWhereBeamsPass) {
  const std::vector<Drawn> pieces = {wall(0, 0, 1.875, 0), wall(2.125, 0, 4, 0)};
  Session closed;
  EXPECT_EQ(closed.see_often(pieces, 5).walls.objects.size(), 1U);
  std::vector<Drawn> seen_behind = pieces;
  seen_behind.push_back(wall(1, -2, 3, -2));
  Session open;
  EXPECT_EQ(open.see_often(seen_behind, 5).walls.objects.size(), 3U);
}

TEST(Merger, ConnectsEndsWithinTheirRadiusWhereTheLinesMeet) {
  Session session;
  const LocalMap local = session.see_often({wall(0, 0, 3.9, 0), wall(4, 0.15, 4, 3)}, 3);
  const Map map = in_local(local);
  ASSERT_EQ(map.objects.size(), 2U);
  const Point& head = map.points[static_cast<std::size_t>(map.objects[0].points[kHead])];
  ASSERT_NE(head.connected, kNone);
  const Point& tail = map.points[static_cast<std::size_t>(head.connected)];
  EXPECT_EQ(head.property, PointProperty::connected);
  EXPECT_EQ(head.projection, head.connected);
  EXPECT_NEAR(distance(head.location, {4.0, 0.0}), 0.0, kExact);
  EXPECT_NEAR(distance(tail.location, {4.0, 0.0}), 0.0, kExact);
}

TEST(Merger, EndsFurtherThanTheirRadiusStayLoose) {
  Session session;
  const LocalMap local = session.see_often({wall(0, 0, 3.7, 0), wall(4, 0.15, 4, 3)}, 3);
  for (const Point& point : local.walls.points) EXPECT_EQ(point.connected, kNone);
}

TEST(Merger, AllCornersOfARoomAreConnected) {
  Session session;
  const LocalMap local = session.see_often(room(), 3);
  ASSERT_EQ(local.walls.points.size(), 8U);
  for (const Point& point : local.walls.points) EXPECT_NE(point.connected, kNone);
}

TEST(Merger, CornerLeansOnItsWeightAgainstOneBadScan) {
  Session session;
  session.see_often(room(), 100);
  const std::vector<Drawn> bad = {wall(0, 0, 4.04, 0.03), wall(4.04, 0.03, 4, 3), wall(4, 3, 0, 3),
                                  wall(0, 3, 0, 0)};
  const Map map = in_local(session.see(bad));
  double nearest = 1.0;
  for (const Point& point : map.points)
    nearest = std::min(nearest, distance(point.location, {4.0, 0.0}));
  EXPECT_LT(nearest, 0.001);  // one scan of 100 that is 5 cm off moves it less than 0.5 mm more
}

TEST(Merger, WeightOfACornerGrowsAndItsRadiusShrinks) {
  const std::vector<Drawn> seen = {wall(0, 0, 3, 0, CornerMethod::none, CornerMethod::spike)};
  Session session;
  const LocalMap early = session.see_often(seen, 3);
  const LocalMap late = session.see_often(seen, 1000);
  const auto head = [](const LocalMap& local) { return local.walls.points[kHead]; };
  EXPECT_GT(head(late).weight, 10.0 * head(early).weight);
  EXPECT_LE(head(late).weight, 100.0 + kExact);  // the cap
  EXPECT_LT(head(late).radius, head(early).radius);
  EXPECT_NEAR(head(late).radius, 0.1, kExact);
}

TEST(Merger, NearlyStraightCornerLiesBetweenTheEnds) {
  Session session;
  const double slope = 0.3;  // too little for an intersection, too much for one wall
  const LocalMap local =
      session.see_often({wall(0, 0, 2, 0), wall(2, 0.03, 4, 0.03 + 2 * slope)}, 3);
  const Map map = in_local(local);
  ASSERT_EQ(map.objects.size(), 2U);
  // The second wall is the longer one, and comes first.
  EXPECT_NEAR(distance(segment(map, 1).b, segment(map, 0).a), 0.0, kExact);
  EXPECT_NEAR(segment(map, 0).a.y(), 0.015, 0.002);
}

TEST(Merger, WallOfUnknownOrRightFreeSideIsTurned) {
  Map scan = draw({wall(4, 0, 0, 0), wall(4, 3, 0, 3)});
  scan.objects[0].free_side = FreeSide::right;
  scan.objects[1].free_side = FreeSide::unknown;
  Session session;
  session.take(transform(scan, inverse(kRobot)), kRobot);
  ASSERT_EQ(session.walls().size(), 2U);
  for (const Wall& seen : session.walls())
    EXPECT_GT(signed_distance(seen.segment, kRobot.location()), 0.0);
}

TEST(Merger, LeavesOutWhatIsNoWall) {
  Map scan = draw({wall(0, 0, 4, 0), wall(1, 1, 1.01, 1)});
  add_segment(scan, {{0.0, 1.0}, {1.0, 1.0}}, ObjectType::door);
  add_point(scan, {2.0, 2.0});
  Session session;
  session.take(scan, {});
  EXPECT_EQ(session.walls().size(), 1U);
}

TEST(Merger, WallWithoutCovarianceIsTakenWithDoubt) {
  Map scan;
  add_segment(scan, {{0.0, 0.0}, {4.0, 0.0}}, ObjectType::wall);
  scan.objects[0].free_side = FreeSide::left;
  Session session;
  session.take(scan, {});
  ASSERT_EQ(session.walls().size(), 1U);
  EXPECT_GT(session.walls()[0].covariance(0, 0), 0.02 * 0.02);
  EXPECT_DOUBLE_EQ(session.walls()[0].ends[kHead].radius, 0.2);
}

TEST(Merger, ClearForgetsEverything) {
  Session session;
  session.see_often(room(), 5);
  session.merger().clear();
  EXPECT_TRUE(session.walls().empty());
  const LocalMap first = session.see(room(), {7.0, 7.0, 1.0});
  EXPECT_EQ(first.robot_in_local.pose, (Position{7.0, 7.0, 1.0}));
  EXPECT_EQ(session.walls().front().id, 0);
}

}  // namespace
}  // namespace perceptor::merge
