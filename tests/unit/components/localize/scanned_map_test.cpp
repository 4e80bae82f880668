/// Maps made of scans: walls that are off by a decimetre, and bent.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "common/geometry/angle.hpp"
#include "components/localize/beam_alignment.hpp"
#include "components/localize/search.hpp"
#include "tests/unit/components/localize/building.hpp"

namespace perceptor::localize {
namespace {

std::vector<Beam> beams_from(const test::Scene& scene, const Position& robot) {
  return choose_beams(beam_ends(test::sweep(scene, test::pico_laser(0.01), robot)), 72);
}

/// Not known at all.
PoseEstimate loose(const Position& pose) { return {pose, Eigen::Matrix3d::Identity()}; }

TEST(NearestFace, IsOneThatCanBeSeen) {
  const World world(angled_room().map);
  const Face* wall = world.nearest_face({2.0, 0.1}, {0.0, 1.0}, 0.4, 0.15);
  ASSERT_NE(wall, nullptr);
  EXPECT_EQ(wall->segment.a.y(), 0.0);
  EXPECT_EQ(world.nearest_face({2.0, 0.1}, {0.0, -1.0}, 0.4, 0.15), nullptr) << "from behind";
  EXPECT_EQ(world.nearest_face({2.0, 0.5}, {0.0, 1.0}, 0.4, 0.15), nullptr) << "too far";
}

TEST(BeamAlignment, FindsThePoseFromNearBy) {
  const Building building = angled_room();
  const Position robot{2.0, 1.1, 0.5};
  const PoseEstimate found = align_beams(World(building.map), beams_from(building.scene, robot),
                                         loose({2.15, 1.0, 0.55}), {});
  EXPECT_LT(distance(found.pose.location(), robot.location()), 0.01);
  EXPECT_NEAR(found.pose.a, robot.a, 0.005);
  EXPECT_LT(found.covariance(0, 0), 0.01);
}

TEST(BeamAlignment, WhatTheMapDoesNotHaveCountsLittle) {
  const Building building = angled_room();
  test::Scene scene = building.scene;
  const auto box = test::room({{2.6, 0.25}, {2.6, 0.0}, {3.4, 0.0}, {3.4, 0.25}});
  scene.insert(scene.end(), box.begin(), box.end());
  const Position robot{2.0, 1.1, 0.5};
  const PoseEstimate found =
      align_beams(World(building.map), beams_from(scene, robot), loose({2.1, 1.05, 0.5}), {});
  EXPECT_LT(distance(found.pose.location(), robot.location()), 0.05);
}

TEST(BeamAlignment, WithNothingNearThePoseStays) {
  const World world(angled_room().map);
  const PoseEstimate start{{50.0, 50.0, 1.0}, 0.01 * Eigen::Matrix3d::Identity()};
  const PoseEstimate found = align_beams(world, {{{0.0, 0.0}, {1.0, 0.0}, 2.0}}, start, {});
  EXPECT_EQ(found.pose, start.pose);
  EXPECT_NEAR(found.covariance(0, 0), 0.01, 1e-12);
}

/// A corridor with a niche; as it is, and as a map has it that bends upward from x = 4 on.
const std::vector<Vector2> kCorridor = {{0.0, 0.0}, {8.0, 0.0}, {8.0, 1.6}, {3.0, 1.6},
                                        {3.0, 2.4}, {2.0, 2.4}, {2.0, 1.6}, {0.0, 1.6}};
const std::vector<Vector2> kBent = {{0.0, 0.0}, {4.0, 0.0}, {8.0, 0.4}, {7.85, 2.0}, {4.0, 1.6},
                                    {3.0, 1.6}, {3.0, 2.4}, {2.0, 2.4}, {2.0, 1.6},  {0.0, 1.6}};

TEST(Follow, WayIsBentAsTheMapIs) {
  const Building built(kCorridor);
  const World world(Building(kBent).map);
  Question question;
  for (int i = 0; i < 12; ++i) {
    const Position robot{1.5 + 0.4 * i, 0.8, i % 2 == 0 ? 0.2 : -0.2};
    question.keyframes.push_back({robot, beams_from(built.scene, robot)});
  }
  SearchParameters parameters;
  parameters.beams.sigma = 0.1;
  const Hypothesis rigid = judge(world, {}, question, parameters);
  const Hypothesis bent = follow(world, {}, question, parameters);
  EXPECT_GT(bent.log_likelihood, rigid.log_likelihood + 30.0);
  EXPECT_GT(bent.explained, rigid.explained);
  const Position last = compose(bent.local_in_world, question.keyframes.back().robot_in_local);
  EXPECT_NEAR(last.x, 5.9, 0.15);
  EXPECT_NEAR(last.y, 0.8 + 0.19, 0.1);
  EXPECT_NEAR(angle_difference(-0.2, last.a), 0.1, 0.04);
}

TEST(Localizer, FollowsByBeamsThroughAMapThatIsBent) {
  const Building built(kCorridor);
  const StartHint hint{.pose = Position{1.2, 0.8, 0.0}, .areas = {}, .distance = 0.3};
  LocalizerParameters parameters;
  parameters.track_by = TrackBy::beams;
  parameters.search.beams.sigma = 0.1;
  parameters.search.followed = 10;
  parameters.claim.lost_margin = 30.0;
  Localizer localizer(World(Building(kBent).map), parameters, hint);
  WorldPosition position;
  std::int64_t utime = 1'000'000;
  for (int i = 0; i < 160; ++i) {
    const Position robot{1.2 + std::max(0, i - 20) * 0.04, 0.8, 0.2 * std::sin(0.3 * i)};
    position = localizer.update(sight(built, built.scene, robot, robot, utime += 100'000));
  }
  ASSERT_EQ(position.state, State::tracking);
  EXPECT_NEAR(position.robot_in_world->pose.x, 6.75, 0.2);
  EXPECT_NEAR(position.robot_in_world->pose.y, 0.8 + 0.27, 0.1);
}

}  // namespace
}  // namespace perceptor::localize
