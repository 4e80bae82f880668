#include "tools/eval/rooms.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <stdexcept>

#include <gmock/gmock.h>

#include "tools/eval/room_parts.hpp"
#include "tools/eval/room_shapes.hpp"

namespace perceptor {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::Ge;
using ::testing::Gt;
using ::testing::Le;
using ::testing::Lt;

constexpr std::uint64_t kPlans = 60;  // of each kind

void for_each_plan(const std::function<void(const FloorPlan&)>& check) {
  for (const RoomKind kind : kAllRoomKinds)
    for (std::uint64_t i = 0; i < kPlans; ++i) {
      SCOPED_TRACE(::testing::Message() << "kind " << static_cast<int>(kind) << ", plan " << i);
      RoomRandom random = make_room_stream(7, i, RoomStream::plan);
      check(make_room(kind, random));
    }
}

FloorPlan plan_of(RoomKind kind, std::uint64_t number) {
  RoomRandom random = make_room_stream(7, number, RoomStream::plan);
  return make_room(kind, random);
}

bool cross_or_touch(const Segment& s, const Segment& t) {
  const auto side = [](const Segment& line, const Vector2& p) {
    return cross(line.b - line.a, p - line.a);
  };
  const bool cross_each_other =
      side(s, t.a) * side(s, t.b) < 0.0 && side(t, s.a) * side(t, s.b) < 0.0;
  const double nearest_end =
      std::min({distance(s, t.a), distance(s, t.b), distance(t, s.a), distance(t, s.b)});
  return cross_each_other || nearest_end < 1e-6;
}

std::vector<double> sides(const Outline& outline) {
  std::vector<double> lengths;
  for (std::size_t i = 0; i < outline.size(); ++i)
    lengths.push_back(distance(outline[i], outline[(i + 1) % outline.size()]));
  return lengths;
}

TEST(Rooms, NoTwoWallsCross) {
  for_each_plan([](const FloorPlan& plan) {
    const std::vector<PlanWall> all = walls(plan);
    for (std::size_t i = 0; i < all.size(); ++i)
      for (std::size_t j = i + 1; j < all.size(); ++j) {
        const bool are_neighbours =
            all[i].next == static_cast<int>(j) || all[j].next == static_cast<int>(i);
        ASSERT_FALSE(!are_neighbours && cross_or_touch(all[i].segment, all[j].segment));
      }
  });
}

TEST(Rooms, FreeSpaceLiesOnTheLeftOfEachWall) {
  for_each_plan([](const FloorPlan& plan) {
    for (const PlanWall& wall : walls(plan)) {
      const Vector2 to_the_left = 0.001 * perpendicular(direction(wall.segment));
      ASSERT_TRUE(is_free(plan, middle(wall.segment) + to_the_left));
      ASSERT_FALSE(is_free(plan, middle(wall.segment) - to_the_left));
    }
  });
}

TEST(Rooms, EachWallEndsWhereTheNextBegins) {
  for_each_plan([](const FloorPlan& plan) {
    const std::vector<PlanWall> all = walls(plan);
    for (const PlanWall& wall : all)
      ASSERT_EQ(wall.segment.b, all[static_cast<std::size_t>(wall.next)].segment.a);
  });
}

TEST(Rooms, TheRobotStandsInFreeSpaceAwayFromTheWalls) {
  RoomRandom random = make_room_stream(1, 2, RoomStream::pose);
  for_each_plan([&](const FloorPlan& plan) {
    const Position pose = free_pose(plan, random);
    ASSERT_TRUE(is_free(plan, pose.location()));
    ASSERT_THAT(clearance(walls(plan), pose.location()), Ge(0.3));
  });
}

TEST(Rooms, APlaceThatIsNotThereIsAnError) {
  RoomRandom random = make_room_stream(1, 2, RoomStream::pose);
  EXPECT_THROW(free_pose({{rectangle(3.0, 0.5)}}, random), std::runtime_error);
}

TEST(Rooms, NoTwoPlansAreAlike) {
  std::set<double> wall_lengths;
  for_each_plan([&](const FloorPlan& plan) {
    double sum = 0.0;
    for (const PlanWall& wall : walls(plan)) sum += length(wall.segment);
    wall_lengths.insert(sum);
  });
  EXPECT_EQ(wall_lengths.size(), kAllRoomKinds.size() * kPlans);
}

TEST(Rooms, AnEscapeRoomHasOneExit) {
  for (std::uint64_t i = 0; i < kPlans; ++i) {
    const std::vector<PlanWall> all = walls(plan_of(RoomKind::escape, i));
    ASSERT_EQ(all.size(), 8U);
    ASSERT_EQ(std::ranges::count_if(all, &PlanWall::ends_in_convex), 2);
  }
}

TEST(Rooms, ACorridorHasRoomsOnBothSides) {
  for (std::uint64_t i = 0; i < kPlans; ++i) {
    const FloorPlan plan = plan_of(RoomKind::corridor, i);
    const auto [low, high] = bounds(plan);
    ASSERT_THAT(low.y(), Lt(-2.0));
    ASSERT_THAT(high.y(), Gt(3.2));
  }
}

TEST(Rooms, ASlantedRoomHasAnAcuteAndAnObtuseCorner) {
  for (std::uint64_t i = 0; i < kPlans; ++i) {
    const Outline outline = plan_of(RoomKind::slanted, i).outlines.front();
    double sharpest = 10.0;
    double bluntest = -10.0;
    for (std::size_t k = 0; k < outline.size(); ++k) {
      const Vector2 before = unit(outline[k] - outline[(k + 1) % outline.size()]);
      const Vector2 after =
          unit(outline[(k + 2) % outline.size()] - outline[(k + 1) % outline.size()]);
      const double angle = std::acos(before.dot(after));
      sharpest = std::min(sharpest, angle);
      bluntest = std::max(bluntest, angle);
    }
    ASSERT_THAT(sharpest, Lt(1.4));
    ASSERT_THAT(bluntest, Gt(1.75));
  }
}

TEST(Rooms, CluttersSidesAreThoseOfFurniture) {
  std::size_t things = 0;
  for (std::uint64_t i = 0; i < kPlans; ++i) {
    const FloorPlan plan = plan_of(RoomKind::cluttered, i);
    for (std::size_t k = 1; k < plan.outlines.size(); ++k, ++things)
      ASSERT_THAT(sides(plan.outlines[k]), ::testing::Each(AllOf(Ge(0.299), Le(1.501))));
  }
  EXPECT_THAT(things, Gt(2 * kPlans));
}

TEST(RoomParts, ABentWallRunsThroughThePath) {
  Outline outline = rectangle(4.0, 3.0);
  bend_wall(outline, 1, {{1.0, 0.0}, {1.0, -0.2}, {2.0, -0.2}, {2.0, 0.0}});
  EXPECT_THAT(outline, ElementsAre(Vector2(0, 0), Vector2(4, 0), Vector2(4, 1), Vector2(4.2, 1),
                                   Vector2(4.2, 2), Vector2(4, 2), Vector2(4, 3), Vector2(0, 3)));
}

TEST(RoomParts, DoorwaysAreAsWideAsDoors) {
  RoomRandom random = make_room_stream(3, 0, RoomStream::plan);
  for (int i = 0; i < 200; ++i) {
    RoomBehind room{.begin = 1.0, .end = 3.0};
    place_door(random, room);
    ASSERT_THAT(room.door_end - room.door_begin, AllOf(Ge(0.7), Le(1.2)));
    ASSERT_THAT(room.door_begin, Ge(room.begin));
    ASSERT_THAT(room.door_end, Le(room.end));
    ASSERT_THAT(wall_thickness(random), AllOf(Ge(0.1), Le(0.2)));
  }
}

TEST(FloorPlan, ConvexCornersStickOutIntoFreeSpace) {
  const FloorPlan plan{{rectangle(4.0, 3.0), moved(box(1.0, 1.0, 0.0), {2.0, 1.5})}};
  for (const PlanWall& wall : walls(plan)) EXPECT_EQ(wall.ends_in_convex, wall.outline == 1);
}

TEST(FloorPlan, TellsSoundPlansFromOthers) {
  const Outline room = rectangle(4.0, 3.0);
  const Outline thing = box(1.0, 1.0, 0.0);
  EXPECT_TRUE(is_sound({{room, moved(thing, {2.0, 1.5})}}));
  EXPECT_FALSE(is_sound({{room, moved(thing, {0.2, 1.5})}})) << "crosses a wall";
  EXPECT_FALSE(is_sound({{room, moved(thing, {0.6, 1.5})}})) << "too near a wall";
  EXPECT_FALSE(is_sound({{room, moved(thing, {6.0, 1.5})}})) << "outside";
  EXPECT_FALSE(is_sound({{room, moved(thing, {2.0, 1.5}), moved(box(0.3, 0.3, 0), {2.0, 1.5})}}))
      << "within another";
  EXPECT_FALSE(is_sound({{{{0, 0}, {4, 0}, {0, 3}, {4, 3}}}})) << "crosses itself";
  EXPECT_FALSE(is_sound({{{{0, 0}, {2, 0}, {4, 0}, {4, 3}}}})) << "a corner that is none";
}

}  // namespace
}  // namespace perceptor
