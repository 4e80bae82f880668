#include "components/localize/localizer.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "common/geometry/angle.hpp"
#include "tests/unit/components/localize/building.hpp"

namespace perceptor::localize {
namespace {

constexpr std::int64_t kPeriod = 100'000;  // [us]

void expect_near(const Position& actual, const Position& expected, double metres, double radians) {
  EXPECT_LT(distance(actual.location(), expected.location()), metres);
  EXPECT_LT(std::abs(angle_difference(actual.a, expected.a)), radians);
}

TEST(Alignment, TellsHowFarTheWallsStandOffTheMap) {
  const Building building = angled_room();
  const Position robot{2.0, 1.1, 0.0};
  std::vector<LocalWall> walls = local_walls(walls_in(building, robot, 1), 0);
  const World world(building.map);
  const auto exact = align(world, walls, {robot, {}}, false, {});
  ASSERT_TRUE(exact && exact->map_variance);
  EXPECT_NEAR(*exact->map_variance, 0.0, 1e-6);
  for (std::size_t i = 0; i < walls.size(); ++i) {
    const Vector2 off = (i % 2 == 0 ? 0.03 : -0.03) * walls[i].line.normal;
    walls[i].line.middle += off;
    walls[i].segment = {walls[i].segment.a + off, walls[i].segment.b + off};
  }
  const auto displaced = align(world, walls, {robot, {}}, false, {});
  ASSERT_TRUE(displaced && displaced->map_variance);
  EXPECT_GT(std::sqrt(*displaced->map_variance), 0.01);
  EXPECT_LT(std::sqrt(*displaced->map_variance), 0.06);
}

TEST(Alignment, FindsThePoseFromNearBy) {
  const Building building = angled_room();
  const Position robot{2.0, 1.1, 2.0};
  const auto walls = local_walls(walls_in(building, robot, 1), 0);
  const auto alignment = align(World(building.map), walls, {{2.1, 1.0, 2.08}, {}}, false, {});
  ASSERT_TRUE(alignment);
  EXPECT_EQ(alignment->matched, 6);
  expect_near(alignment->frame_in_world.pose, robot, 1e-4, 1e-4);
  EXPECT_LT(alignment->frame_in_world.covariance(0, 0), 1e-3);
}

TEST(Alignment, OneWallLeavesThePoseLoose) {
  const Building building = angled_room();
  Map one = walls_in(building, {2.0, 1.1, 0.0}, 1);
  one.objects.resize(1);
  for (Point& end : one.points) end.method = CornerMethod::none;
  const auto walls = local_walls(one, 0);
  ASSERT_EQ(walls.size(), 1U);
  const World world(building.map);
  EXPECT_FALSE(align(world, walls, {{2.0, 1.1, 0.0}, {}}, false, {}));
  const PoseEstimate prior{{2.0, 1.2, 0.0}, 0.01 * Eigen::Matrix3d::Identity()};
  const auto with_prior = align(world, walls, prior, true, {});
  ASSERT_TRUE(with_prior);
  EXPECT_NEAR(with_prior->frame_in_world.pose.y, 1.1, 0.01);
  EXPECT_NEAR(with_prior->frame_in_world.pose.x, 2.0, 1e-9);
  EXPECT_NEAR(with_prior->frame_in_world.covariance(0, 0), 0.01, 1e-6);
}

TEST(Candidates, TruthIsAmongThem) {
  const Building building = angled_room();
  const Position local_in_world{1.5, 2.5, -2.2};
  const auto walls = local_walls(walls_in(building, local_in_world, 1), 0);
  const auto candidates = find_candidates(World(building.map), walls, {});
  ASSERT_FALSE(candidates.empty());
  expect_near(candidates.front().local_in_world, local_in_world, 0.15, 0.1);
  EXPECT_NEAR(candidates.front().explained, 18.0, 0.1);
  for (std::size_t i = 1; i < candidates.size(); ++i)
    EXPECT_LE(candidates[i].explained, candidates[i - 1].explained);
}

TEST(Candidates, OneWallInViewIsSlidAlongAllFronts) {
  const Building building = angled_room();
  const Position local_in_world{2.0, 1.1, 0.3};
  std::vector<LocalWall> walls = local_walls(walls_in(building, local_in_world, 1), 0);
  walls.resize(1);
  walls.front().is_corner = {false, false};
  const auto candidates = find_candidates(World(building.map), walls, {});
  EXPECT_TRUE(std::ranges::any_of(candidates, [&](const Candidate& candidate) {
    return distance(candidate.local_in_world.location(), local_in_world.location()) < 0.15 &&
           std::abs(angle_difference(candidate.local_in_world.a, local_in_world.a)) < 0.02;
  }));
}

TEST(LaidWalls, LongWallsThatTheMapDoesNotHaveAreStrange) {
  const Building building = angled_room();
  const World world(building.map);
  const Position local_in_world{2.0, 1.1, 0.3};
  std::vector<LocalWall> walls = local_walls(walls_in(building, local_in_world, 1), 0);
  const auto strange = [&](const Position& place) {
    return strange_length(world, walls, place, {}, 0.8);
  };
  EXPECT_EQ(strange(local_in_world), 0.0);
  EXPECT_NEAR(explained_length(world, walls, local_in_world, {}), 18.0, 1e-6);
  walls.front().segment.b = walls.front().segment.a + 0.5 * walls.front().line.along;
  walls.front().line = line_of(walls.front().segment);
  const Position aside = local_in_world + Position{0.5, 0.5, 0.0};
  EXPECT_NEAR(strange(aside), 18.0 - 5.0, 1e-6);
}

TEST(Views, TurningAroundShowsNoMoreThanTwo) {
  std::vector<Keyframe> keyframes(1);
  EXPECT_EQ(views(keyframes, {}), 1.0);
  for (int i = 1; i <= 12; ++i) keyframes.push_back({{0.0, 0.0, wrap_angle(i * 1.0)}, {}, 0.0});
  EXPECT_EQ(views(keyframes, {}), 3.0);
  keyframes.push_back({{1.0, 0.0, 0.0}, {}, 0.0});
  EXPECT_EQ(views(keyframes, {}), 5.0);
}

TEST(Views, ComingBackShowsNothingNew) {
  std::vector<Keyframe> keyframes;
  for (const double x : {0.0, 0.5, 1.0}) keyframes.push_back({{x, 0.0, 0.0}, {}, 0.0});
  EXPECT_EQ(views(keyframes, {}), 3.0);
  for (const double x : {0.75, 0.5, 0.0, 0.5}) keyframes.push_back({{x, 0.0, 0.0}, {}, 0.0});
  EXPECT_EQ(views(keyframes, {}), 3.5);
}

/// A robot that turns in place, and then drives on, somewhere in a building.
class Drive {
 public:
  Drive(const Building& building, const Position& start,
        const std::optional<StartHint>& hint = std::nullopt)
      : Drive(building, building, start, hint) {}

  /// Where the building is not as it was drawn.
  Drive(const Building& drawn, const Building& built, const Position& start,
        const std::optional<StartHint>& hint = std::nullopt)
      : building_(built),
        scene_(built.scene),
        start_(start),
        localizer_(World(drawn.map), {}, hint) {}

  WorldPosition turn(double radians) {
    WorldPosition last;
    constexpr double kStep = 0.1;
    for (int i = 0; i * kStep < radians; ++i) {
      in_local_.a = wrap_angle(in_local_.a + kStep);
      last = look();
    }
    return last;
  }

  WorldPosition look() {
    utime_ += kPeriod;
    const WorldPosition now =
        localizer_.update(sight(building_, scene_, truth(), in_local_, utime_));
    if (last_.state == State::tracking && now.state == State::tracking) {
      EXPECT_LT(
          distance(last_.robot_in_world->pose.location(), now.robot_in_world->pose.location()), 0.3)
          << "elsewhere, and was not lost between";
    }
    return last_ = now;
  }

  /// Somebody lifts the robot, and odometry notices nothing.
  void kidnap(const Position& to) { start_ = compose(to, inverse(in_local_)); }
  void place(const test::Scene& things) {
    scene_.insert(scene_.end(), things.begin(), things.end());
  }

  Position truth() const { return compose(start_, in_local_); }
  Localizer& localizer() { return localizer_; }

 private:
  Building building_;
  test::Scene scene_;
  Position start_;  ///< the local frame, in the world
  Position in_local_;
  std::int64_t utime_ = 1'000'000;
  WorldPosition last_;
  Localizer localizer_;
};

TEST(Localizer, FindsTheRobotFromNothingAndFollowsIt) {
  Drive drive(angled_room(), {1.2, 2.9, -1.0});
  EXPECT_EQ(drive.look().state, State::searching);
  const WorldPosition found = drive.turn(1.5);
  ASSERT_EQ(found.state, State::tracking);
  ASSERT_TRUE(found.robot_in_world);
  expect_near(found.robot_in_world->pose, drive.truth(), 0.01, 0.005);
  EXPECT_GT(found.explained, 0.9);
  EXPECT_FALSE(found.ambiguous);
  const WorldPosition later = drive.turn(6.0);
  EXPECT_EQ(later.state, State::tracking);
  expect_near(later.robot_in_world->pose, drive.truth(), 0.002, 0.002);
}

TEST(Localizer, SaysThatARoomIsAmbiguous) {
  Drive drive(plain_room(), {1.2, 1.0, 0.3});
  const WorldPosition position = drive.turn(4.0);
  EXPECT_EQ(position.state, State::searching);
  EXPECT_TRUE(position.ambiguous);
  EXPECT_GE(position.places, 2);
}

StartHint near(const Position& pose) { return {.pose = pose, .areas = {}}; }

TEST(Localizer, RobotThatStandsStillIsFoundNearTheHint) {
  Drive drive(plain_room(), {1.2, 1.0, 0.3}, near({1.5, 0.9, 0.1}));
  WorldPosition position;
  for (int i = 0; i < 10; ++i) position = drive.look();
  ASSERT_EQ(position.state, State::tracking);
  expect_near(position.robot_in_world->pose, drive.truth(), 0.01, 0.005);
}

TEST(Localizer, StartAreaTellsApartWhatLooksAlike) {
  const StartHint lower_left{.pose = std::nullopt,
                             .areas = {{{0.0, 0.0}, {1.8, 0.0}, {1.8, 1.4}, {0.0, 1.4}}},
                             .distance = 0.1};
  Drive drive(plain_room(), {1.2, 1.0, 0.3}, lower_left);
  const WorldPosition position = drive.turn(2.0);
  ASSERT_EQ(position.state, State::tracking);
  expect_near(position.robot_in_world->pose, drive.truth(), 0.01, 0.005);
}

TEST(Localizer, HintEndsWhenTheRobotWasLost) {
  Drive drive(angled_room(), {1.2, 2.9, -1.0}, near({1.2, 2.9, -1.0}));
  ASSERT_EQ(drive.turn(1.5).state, State::tracking);
  drive.kidnap({4.2, 1.0, 2.0});
  const WorldPosition again = drive.turn(4.0);
  ASSERT_EQ(again.state, State::tracking);
  expect_near(again.robot_in_world->pose, drive.truth(), 0.01, 0.005);
}

TEST(Localizer, NoticesThatItWasCarriedAway) {
  Drive drive(angled_room(), {1.2, 2.9, -1.0});
  ASSERT_EQ(drive.turn(1.5).state, State::tracking);
  drive.kidnap({4.2, 1.0, 2.0});
  WorldPosition position;
  for (int i = 0; i < 20 && position.state != State::lost; ++i) position = drive.look();
  EXPECT_EQ(position.state, State::lost);
  const WorldPosition again = drive.turn(2.0);
  ASSERT_EQ(again.state, State::tracking);
  expect_near(again.robot_in_world->pose, drive.truth(), 0.01, 0.005);
}

TEST(Localizer, BetterPoseCloseByMendsTheClaim) {
  const Building corridor({{0.0, 0.0},
                           {6.0, 0.0},
                           {6.0, 1.4},
                           {2.0, 1.4},
                           {2.0, 2.2},
                           {1.2, 2.2},
                           {1.2, 1.4},
                           {0.0, 1.4}});
  Drive drive(corridor, {3.6, 0.7, 0.0});
  ASSERT_EQ(drive.turn(6.0).state, State::tracking);
  const Position before = drive.truth();
  drive.kidnap({before.x + 0.2, before.y, before.a});
  double last = 1.0;
  for (int i = 0; i < 40; ++i) {
    const WorldPosition position = drive.turn(0.5);
    ASSERT_EQ(position.state, State::tracking);
    last = distance(position.robot_in_world->pose.location(), drive.truth().location());
  }
  EXPECT_LT(last, 0.02);
}

TEST(Localizer, BearsBeingCarriedAroundAllTheTime) {
  Drive drive(angled_room(), {1.2, 2.9, -1.0});
  for (int i = 0; i < 20; ++i) {
    drive.turn(0.7);
    drive.kidnap(i % 2 == 0 ? Position{4.2, 1.0, 2.0} : Position{1.2, 2.9, -1.0});
  }
  drive.kidnap({1.0, 1.0, 0.0});
  const WorldPosition last = drive.turn(6.0);
  ASSERT_EQ(last.state, State::tracking);
  expect_near(last.robot_in_world->pose, drive.truth(), 0.01, 0.005);
}

TEST(Localizer, UnknownBoxesDoNotMatter) {
  Drive drive(angled_room(), {1.2, 2.9, -1.0});
  drive.place(test::room({{2.0, 0.5}, {2.4, 0.5}, {2.4, 0.8}, {2.0, 0.8}}));
  drive.place(test::room({{0.3, 3.5}, {0.6, 3.5}, {0.6, 3.7}, {0.3, 3.7}}));
  const WorldPosition found = drive.turn(1.5);
  ASSERT_EQ(found.state, State::tracking);
  expect_near(found.robot_in_world->pose, drive.truth(), 0.01, 0.005);
}

TEST(Localizer, WallThatIsGoneDoesNotHideTheRest) {
  Building drawn = angled_room();
  const Index gone = add_segment(drawn.map, {{1.8, 4.0}, {1.8, 2.9}}, ObjectType::wall);
  drawn.map.objects[static_cast<std::size_t>(gone)].free_side = FreeSide::right;
  const Building built = angled_room();
  Drive drive(drawn, built, {1.2, 2.0, -1.0});
  const WorldPosition found = drive.turn(4.0);
  ASSERT_EQ(found.state, State::tracking);
  expect_near(found.robot_in_world->pose, drive.truth(), 0.01, 0.005);
  EXPECT_GT(found.through, 0.04);
}

TEST(Localizer, ClearForgetsAll) {
  Drive drive(angled_room(), {1.2, 2.9, -1.0});
  ASSERT_EQ(drive.turn(1.5).state, State::tracking);
  drive.localizer().clear();
  EXPECT_EQ(drive.look().state, State::searching);
}

TEST(Localizer, CallsSomebodyWhileItWaitsForASearch) {
  const Building building = angled_room();
  int calls = 0;
  Localizer localizer(World(building.map), {}, std::nullopt, [&calls] { ++calls; });
  const Position robot{1.2, 2.9, -1.0};
  localizer.update(sight(building, building.scene, robot, {}, 1'000'000));
  localizer.update(sight(building, building.scene, robot, {}, 1'200'000));
  EXPECT_EQ(calls, 0) << "the answer is not asked for yet";
  localizer.update(sight(building, building.scene, robot, {}, 1'300'000));
  EXPECT_GT(calls, 0);
}

TEST(Localizer, SameScansGiveTheSameAnswers) {
  Drive first(angled_room(), {1.2, 2.9, -1.0});
  Drive second(angled_room(), {1.2, 2.9, -1.0});
  for (int i = 0; i < 30; ++i) {
    const WorldPosition p = first.turn(0.1);
    const WorldPosition q = second.turn(0.1);
    ASSERT_EQ(p.state, q.state);
    ASSERT_EQ(p.robot_in_world.has_value(), q.robot_in_world.has_value());
    EXPECT_EQ(p.robot_in_world.value_or(PoseEstimate{}).pose,
              q.robot_in_world.value_or(PoseEstimate{}).pose);
  }
}

}  // namespace
}  // namespace perceptor::localize
