#include "components/localize/combined_map.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "tests/unit/components/localize/building.hpp"

namespace perceptor::localize {
namespace {

constexpr std::int64_t kPeriod = 100'000;  // [us]
const Segment kDoorway{{4.0, 1.5}, {4.0, 2.5}};

/// Two rooms beside each other, a thin wall between them with a doorway in it, which no one drew.
Building two_rooms() {
  Building building({{0.0, 0.0}, {8.0, 0.0}, {8.0, 4.0}, {0.0, 4.0}});
  for (const Segment& wall : {Segment{{4.0, 0.0}, kDoorway.a}, Segment{kDoorway.b, {4.0, 4.0}}}) {
    building.scene.push_back(wall);
    add_segment(building.map, wall, ObjectType::wall);
  }
  return building;
}

test::Scene with_box(test::Scene scene, const Vector2& corner) {
  constexpr double kSide = 0.4;
  const std::vector<Vector2> corners = {corner, corner + Vector2(kSide, 0.0),
                                        corner + Vector2(kSide, kSide),
                                        corner + Vector2(0.0, kSide)};
  for (std::size_t i = 0; i < 4; ++i) scene.push_back({corners[i], corners[(i + 1) % 4]});
  return scene;
}

/// What a robot makes of the two rooms, standing in the left one.
class CombinedMapTest : public testing::Test {
 protected:
  void look(const test::Scene& scene, double seconds, const Position& error = {}) {
    const PoseEstimate pose{robot_ + error, 1e-6 * Eigen::Matrix3d::Identity()};
    const auto end = utime_ + static_cast<std::int64_t>(seconds * 1e6);
    for (; utime_ < end; utime_ += kPeriod)
      combined_.add(pose, beam_ends(test::sweep(scene, test::pico_laser(0.01), robot_)), utime_);
  }

  std::vector<Object> objects(ObjectType type) {
    map_ = combined_.map(utime_);
    EXPECT_EQ(find_broken_reference(map_), "");
    std::vector<Object> objects;
    for (const Object& object : map_.objects)
      if (object.type == type) objects.push_back(object);
    return objects;
  }

  std::string door() {
    const std::vector<Object> doors = objects(ObjectType::door);
    return doors.size() == 1 ? doors.front().reason : std::to_string(doors.size()) + " doors";
  }

  const Building building_ = two_rooms();
  const World world_{building_.map};
  CombinedMap combined_{world_, building_.map, {}, {}};
  Position robot_{1.2, 2.1, 0.2};
  std::int64_t utime_ = 1'000'000;
  Map map_;
};

TEST_F(CombinedMapTest, NothingIsKnownAtFirst) {
  EXPECT_EQ(door(), "unseen");
  for (const Object& wall : objects(ObjectType::wall)) EXPECT_EQ(wall.reason, "unseen");
  EXPECT_EQ(objects(ObjectType::wall).size(), building_.map.objects.size());
}

TEST_F(CombinedMapTest, WallsInViewAreConfirmed) {
  look(building_.scene, 1.0);
  const std::vector<Object> walls = objects(ObjectType::wall);
  EXPECT_EQ(walls[0].reason, "confirmed") << "along both rooms";
  EXPECT_EQ(walls[4].reason, "confirmed") << "between the rooms";
  EXPECT_TRUE(objects(ObjectType::static_obstacle).empty());
  EXPECT_TRUE(objects(ObjectType::dynamic_obstacle).empty());
}

TEST_F(CombinedMapTest, WallThatIsNotThereIsContradicted) {
  test::Scene without = building_.scene;
  std::erase_if(without, [](const Segment& wall) { return wall.b == Vector2(4.0, 4.0); });
  look(without, 1.0);
  EXPECT_EQ(objects(ObjectType::wall)[5].reason, "contradicted");
}

TEST_F(CombinedMapTest, DoorIsKnownWithinASecondOfItsChange) {
  test::Scene shut = building_.scene;
  shut.push_back(kDoorway);
  look(building_.scene, 1.0);
  EXPECT_EQ(door(), "open");
  look(shut, 1.0);
  EXPECT_EQ(door(), "shut");
  look(building_.scene, 1.0);
  EXPECT_EQ(door(), "open");
}

TEST_F(CombinedMapTest, LeafThatStandsBackIsShut) {
  test::Scene shut = building_.scene;
  shut.push_back({{4.1, 1.5}, {4.1, 2.5}});
  look(shut, 1.0);
  EXPECT_EQ(door(), "shut");
  EXPECT_TRUE(objects(ObjectType::static_obstacle).empty());
}

TEST_F(CombinedMapTest, ThingThatStaysIsStatic) {
  look(with_box(building_.scene, {2.5, 2.6}), 3.0);
  const std::vector<Object> things = objects(ObjectType::static_obstacle);
  ASSERT_EQ(things.size(), 1U);
  EXPECT_GT(things.front().weight, 20.0);
  EXPECT_GE(things.front().last_seen - things.front().first_seen, 2'500'000);
  for (const Index corner : things.front().points)
    EXPECT_LT(distance(map_.points[static_cast<std::size_t>(corner)].location, Vector2(2.7, 2.8)),
              0.45);
  const std::int32_t id = things.front().id;
  look(with_box(building_.scene, {2.5, 2.6}), 1.0);
  EXPECT_EQ(objects(ObjectType::static_obstacle).at(0).id, id);
  look(building_.scene, 6.0);
  EXPECT_TRUE(objects(ObjectType::static_obstacle).empty()) << "it was taken away";
}

TEST_F(CombinedMapTest, ThingThatMovesIsDynamic) {
  for (int i = 0; i < 30; ++i) {
    look(with_box(building_.scene, {2.4, 0.3 + 0.09 * i}), 0.1);
    EXPECT_TRUE(objects(ObjectType::static_obstacle).empty());
  }
  EXPECT_FALSE(objects(ObjectType::dynamic_obstacle).empty());
}

TEST_F(CombinedMapTest, NothingIsAddedFromAWrongPose) {
  for (const Position& error : {Position{0.0, 0.0, 0.17}, Position{0.0, 0.0, -0.17},
                                Position{0.3, 0.0, 0.0}, Position{0.0, -0.3, 0.0}}) {
    look(building_.scene, 3.0, error);
    EXPECT_TRUE(objects(ObjectType::static_obstacle).empty());
    for (const Object& wall : objects(ObjectType::wall)) EXPECT_NE(wall.reason, "contradicted");
  }
}

TEST_F(CombinedMapTest, NothingIsAddedWhileUncertain) {
  const PoseEstimate loose{robot_, 0.02 * Eigen::Matrix3d::Identity()};
  combined_.add(loose, beam_ends(test::sweep(building_.scene, test::pico_laser(0.01), robot_)), 1);
  for (const Object& wall : objects(ObjectType::wall)) EXPECT_EQ(wall.weight, 0.0);
}

TEST_F(CombinedMapTest, ForgetsAllWhenThePlaceWasWrong) {
  look(with_box(building_.scene, {2.5, 2.6}), 3.0);
  combined_.clear();
  EXPECT_EQ(door(), "unseen");
  EXPECT_TRUE(objects(ObjectType::static_obstacle).empty());
  for (const Object& wall : objects(ObjectType::wall)) EXPECT_EQ(wall.reason, "unseen");
}

/// Of so many cells side by side, hit ten times a second.
class StandingThing {
 public:
  explicit StandingThing(int cells) : is_unknown_(static_cast<std::size_t>(cells), true) {
    for (int i = 0; i < cells; ++i) {
      const Vector2 end(2.05, 0.1 * i + 0.05);
      beams_.push_back({Vector2::Zero(), unit(end), end.norm()});
    }
  }

  std::ptrdiff_t statics_after(double seconds) {
    for (int i = 0; i < static_cast<int>(seconds * 10.0); ++i) {
      utime_ += 100'000;
      objects_.add(beams_, is_unknown_, utime_);
    }
    return std::ranges::count_if(objects_.objects(utime_), &UnknownObject::is_static);
  }

 private:
  UnknownObjects objects_{UnknownObjectParameters()};
  std::vector<WorldBeam> beams_;
  std::vector<bool> is_unknown_;
  std::int64_t utime_ = 0;
};

TEST(UnknownObjects, WhatIsNarrowHasToStayForLonger) {
  for (const int cells : {1, 3}) {
    StandingThing narrow(cells);
    EXPECT_EQ(narrow.statics_after(3.0), 0) << cells;
    EXPECT_EQ(narrow.statics_after(3.0), 1) << cells;
  }
  EXPECT_EQ(StandingThing(4).statics_after(3.0), 1);
}

TEST(UnknownObjects, AreBoundedInNumber) {
  UnknownObjectParameters parameters;
  parameters.max_cells = 50;
  UnknownObjects objects(parameters);
  for (int i = 0; i < 1000; ++i) {
    const double bearing = 0.0063 * i;
    const std::vector<WorldBeam> beams = {
        {{0.0, 0.0}, {std::cos(bearing), std::sin(bearing)}, 5.0}};
    objects.add(beams, {true}, i * kPeriod);
  }
  EXPECT_LE(objects.objects(1000 * kPeriod).size(), 50U);
}

}  // namespace
}  // namespace perceptor::localize
