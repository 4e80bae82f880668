#include "tools/eval/true_world.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "tests/unit/tools/eval/true_room.hpp"

namespace perceptor {
namespace {

TEST(TrueWorld, AnOpeningInAThickWallHasTwoFaces) {
  const TrueWorld world = testing::true_rooms();
  ASSERT_EQ(world.openings.size(), 1U);
  const TrueOpening& opening = world.openings[0];
  EXPECT_TRUE(opening.is_open);
  ASSERT_EQ(opening.faces.size(), 2U);
  double xs = 0.0;
  for (const OpeningFace& face : opening.faces) {
    EXPECT_NEAR(length(face.segment), 1.0, 1e-9);
    xs += middle(face.segment).x();
  }
  EXPECT_NEAR(xs, 4.0 + 4.2, 1e-9);
}

TEST(TrueWorld, EachFaceKnowsTheWallsBesideIt) {
  const TrueWorld world = testing::true_rooms();
  for (const OpeningFace& face : world.openings[0].faces)
    for (const std::size_t side : face.adjoining) {
      ASSERT_NE(side, kNoSide);
      const Segment& wall = world.sides[side].segment;
      EXPECT_NEAR(length(wall), 1.0, 1e-9);
      EXPECT_NEAR(wall.a.x(), face.segment.a.x(), 1e-9);
      EXPECT_NEAR(wall.b.x(), face.segment.a.x(), 1e-9);
    }
}

TEST(TrueWorld, EveryCornerOfBothRoomsAndTheJambsIsOne) {
  EXPECT_EQ(testing::true_rooms().corners.size(), 12U);
}

TEST(TrueWorld, AShutDoorIsALeafAndNoCorner) {
  const TrueWorld world = testing::true_rooms(testing::two_rooms("shut"));
  EXPECT_FALSE(world.openings[0].is_open);
  EXPECT_EQ(world.sides.back().surface, Surface::leaf);
  EXPECT_EQ(world.corners.size(), 12U);
}

TEST(TrueWorld, FurnitureIsAsFarFromAnOpeningAsFromItsNearestJamb) {
  Map map = testing::two_rooms();
  testing::add_object(map, {{3.5, 0.9}, {3.8, 0.9}}, ObjectType::static_obstacle, 90);
  const TrueWorld world = testing::true_rooms(map);
  EXPECT_NEAR(world.openings[0].from_furniture, std::hypot(0.2, 0.1), 1e-9);
}

}  // namespace
}  // namespace perceptor
