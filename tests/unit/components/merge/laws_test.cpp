/// Laws that hold for every scene, tried on many drawn from a fixed seed.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "tests/unit/components/merge/scene.hpp"

namespace perceptor::merge {
namespace {

constexpr int kScenes = 50;

/// A place of twelve walls around the origin, all of which a robot near it sees; some are
/// missing, some corners are sharp and some nearly straight.
std::vector<Drawn> random_scene(std::mt19937_64& random) {
  constexpr int kWalls = 12;
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<Vector2> corners;
  for (int i = 0; i < kWalls; ++i) {
    const double bearing = 2.0 * std::numbers::pi * i / kWalls;
    const double range = 2.0 + 1.0 * unit(random);
    corners.emplace_back(range * std::cos(bearing), range * std::sin(bearing));
  }
  std::vector<Drawn> scene;
  for (std::size_t i = 0; i < corners.size(); ++i)
    if (unit(random) < 0.8) scene.push_back({{corners[i], corners[(i + 1) % corners.size()]}});
  return scene;
}

void expect_same(const Map& p, const Map& q, double tolerance) {
  ASSERT_EQ(p.objects.size(), q.objects.size());
  ASSERT_EQ(p.points.size(), q.points.size());
  for (std::size_t i = 0; i < p.points.size(); ++i) {
    EXPECT_NEAR(distance(p.points[i].location, q.points[i].location), 0.0, tolerance);
    EXPECT_EQ(p.points[i].connected, q.points[i].connected);
    EXPECT_EQ(p.points[i].property, q.points[i].property);
  }
  for (std::size_t i = 0; i < p.objects.size(); ++i)
    EXPECT_EQ(p.objects[i].points, q.objects[i].points);
}

TEST(Laws, MapMergedWithItselfStaysAsItIs) {
  std::mt19937_64 random(1);
  for (int i = 0; i < kScenes; ++i) {
    Session session;
    const Position robot{0.2, 0.1, 0.4};
    const LocalMap before = session.see_often(random_scene(random), 4, robot);
    LocalMap after = before;
    for (int again = 0; again < 3; ++again) after = session.take(after.walls, robot);
    ASSERT_GE(before.walls.objects.size(), 4U);
    expect_same(before.walls, after.walls, 1e-9);
  }
}

TEST(Laws, OrderInWhichWallsComeChangesNothing) {
  std::mt19937_64 random(2);
  for (int i = 0; i < kScenes; ++i) {
    Session in_order;
    Session shuffled;
    std::vector<Drawn> scene = random_scene(random);
    for (int scan = 0; scan < 4; ++scan) {
      const LocalMap p = in_order.see(scene);
      std::vector<Drawn> mixed = scene;
      std::shuffle(mixed.begin(), mixed.end(), random);
      const LocalMap q = shuffled.see(mixed);
      expect_same(p.walls, q.walls, 0.0);
      EXPECT_EQ(p.robot_in_local.pose, q.robot_in_local.pose);
    }
  }
}

/// A short drive with odometry that errs, starting anywhere.
LocalMap drive(Session& session, const std::vector<Drawn>& scene, const Position& start) {
  const Map world = draw(scene);
  LocalMap last;
  for (int i = 0; i < 20; ++i) {
    const Position truth{0.02 * i, 0.01 * i, 0.05 * i};
    const Position odometry{0.021 * i, 0.01 * i, 0.051 * i};
    last = session.take(transform(world, inverse(truth)), compose(start, odometry));
  }
  return last;
}

TEST(Laws, MovingTheWholeSceneMovesTheMap) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> metres(-20.0, 20.0);
  std::uniform_real_distribution<double> radians(-std::numbers::pi, std::numbers::pi);
  for (int i = 0; i < kScenes; ++i) {
    const std::vector<Drawn> scene = random_scene(random);
    const Position start{metres(random), metres(random), radians(random)};
    Session here;
    Session there;
    const LocalMap p = drive(here, scene, {});
    const LocalMap q = drive(there, scene, start);
    expect_same(p.walls, q.walls, 1e-9);
    expect_same(transform(in_local(p), start), in_local(q), 1e-9);
  }
}

TEST(Laws, HeadingAcrossPiGivesTheSameMapAsAStartFromZero) {
  std::mt19937_64 random(4);
  const std::vector<Drawn> scene = random_scene(random);
  Session zero;
  const LocalMap expected = drive(zero, scene, {});
  for (const double heading : {std::numbers::pi, -std::numbers::pi + 1e-9, 3.0, -3.0}) {
    Session session;
    const LocalMap local = drive(session, scene, {5.0, -3.0, heading});
    expect_same(expected.walls, local.walls, 1e-6);
  }
}

TEST(Laws, ReferencesAreNeverBroken) {
  std::mt19937_64 random(5);
  for (int i = 0; i < kScenes; ++i) {
    Session session;
    for (int scan = 0; scan < 5; ++scan) {
      const LocalMap local = session.see_often(random_scene(random), 3);
      ASSERT_EQ(find_broken_reference(local.walls), "");
    }
  }
}

}  // namespace
}  // namespace perceptor::merge
