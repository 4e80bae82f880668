#include "tools/eval/localize/combined_score.hpp"

#include <gtest/gtest.h>

namespace perceptor {
namespace {

/// A robot before a wall with a doorway; a box stands beside it.
class CombinedScoreTest : public ::testing::Test {
 protected:
  CombinedScoreTest() {
    world_.walls = {{{2.0, -3.0}, {2.0, -0.5}}, {{2.0, 0.5}, {2.0, 3.0}}};
    world_.boxes = {{{1.2, 1.5, 0.0}, 0.4, 0.4}};
  }

  Map map(const char* door, const std::vector<Vector2>& things) const {
    Map map;
    const Index index = add_segment(map, {{2.0, -0.5}, {2.0, 0.5}}, ObjectType::door);
    map.objects[static_cast<std::size_t>(index)].reason = door;
    std::int32_t id = 0;
    for (const Vector2& thing : things) {
      Object object;
      object.type = ObjectType::static_obstacle;
      object.id = ++id;
      for (const Vector2& corner : {Vector2(-0.1, -0.1), Vector2(0.1, -0.1), Vector2(0.1, 0.1)})
        object.points.push_back(add_point(map, thing + corner));
      map.objects.push_back(object);
    }
    return map;
  }

  CombinedScore score(const Map& map, Doors doors,
                      const std::vector<sim::MoverState>& people = {}) {
    CombinedScorer scorer(world_, doors, {});
    sim::Truth truth;
    truth.movers = people;
    for (int i = 0; i < 50; ++i) scorer.take(map, truth, 0.1 * i);
    return scorer.score();
  }

  sim::World world_;
};

TEST_F(CombinedScoreTest, WhatIsThereIsRight) {
  const CombinedScore right = score(map("open", {{1.2, 1.5}}), Doors::open);
  EXPECT_EQ(right.doors.hits, right.doors.cases);
  EXPECT_GT(right.doors.cases, 30);
  EXPECT_EQ(right.objects.hits, right.objects.cases);
  EXPECT_GT(right.objects.cases, 15);
  EXPECT_EQ(right.false_objects, 0);
  EXPECT_NEAR(right.time, 4.9, 1e-9);
}

TEST_F(CombinedScoreTest, WrongStateAndMissingThingCount) {
  const CombinedScore wrong = score(map("shut", {}), Doors::open);
  EXPECT_EQ(wrong.doors.hits, 0);
  EXPECT_EQ(wrong.objects.hits, 0);
  EXPECT_GT(wrong.objects.cases, 0);
}

TEST_F(CombinedScoreTest, ThingWhereNothingIsCountsOnce) {
  EXPECT_EQ(score(map("open", {{0.5, -1.5}}), Doors::open).false_objects, 1);
}

TEST_F(CombinedScoreTest, PersonWhoStandsIsAThing) {
  const sim::MoverState person{{{0.5, -1.5}, 0.25}, Vector2::Zero()};
  CombinedScorer scorer(world_, Doors::open, {});
  sim::Truth truth;
  truth.movers = {person};
  for (int i = 0; i < 50; ++i)
    scorer.take(map("open", i < 30 ? std::vector<Vector2>{} : std::vector<Vector2>{{0.5, -1.5}}),
                truth, 0.1 * i);
  EXPECT_EQ(scorer.score().false_objects, 0);
}

TEST_F(CombinedScoreTest, BlockedDoorwayIsNeither) {
  world_.boxes.push_back({{2.0, 0.0, 0.0}, 0.3, 0.3});
  EXPECT_EQ(score(map("shut", {}), Doors::open).doors.cases, 0);
}

}  // namespace
}  // namespace perceptor
