#include "components/viewer/map_items.hpp"

#include <algorithm>

#include <gmock/gmock.h>

namespace perceptor::viewer {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

std::vector<Mark> marks(const std::vector<Item>& items) {
  std::vector<Mark> marks;
  marks.reserve(items.size());
  for (const Item& item : items) marks.push_back(item.mark);
  return marks;
}

Object& add(Map& map, ObjectType type, const char* reason = "") {
  const Index index = add_segment(map, {{0.0, 0.0}, {2.0, 0.0}}, type);
  Object& object = map.objects[static_cast<std::size_t>(index)];
  object.reason = reason;
  return object;
}

TEST(MapItems, AnEmptyMapGivesNothing) {
  EXPECT_THAT(current_map_items({}), IsEmpty());
  EXPECT_THAT(local_map_items({}), IsEmpty());
  EXPECT_THAT(identified_items({}), IsEmpty());
  EXPECT_THAT(combined_map_items({}), IsEmpty());
}

TEST(MapItems, AWallSaysWhatItIs) {
  Map map;
  Object& wall = add(map, ObjectType::wall);
  wall.id = 7;
  wall.support = 80;
  wall.line_covariance = Eigen::Vector2d(1e-6, 0.0).asDiagonal();
  const std::vector<Item> items = local_map_items(map);
  ASSERT_EQ(items.size(), 1U);
  EXPECT_THAT(items[0].points, ElementsAre(Vector2(0.0, 0.0), Vector2(2.0, 0.0)));
  EXPECT_THAT(items[0].text, HasSubstr("wall 7"));
  EXPECT_THAT(items[0].text, HasSubstr("2.00 m"));
  EXPECT_THAT(items[0].text, HasSubstr("sigma 1.0 mm"));
  EXPECT_THAT(items[0].text, HasSubstr("80 beams"));
}

TEST(MapItems, TwoEndsOfOneCornerGiveOneMark) {
  Map map;
  add(map, ObjectType::wall);
  add_segment(map, {{2.0, 0.0}, {2.0, 2.0}}, ObjectType::wall);
  connect(map, 1, 2);
  for (const std::size_t end : {1U, 2U}) map.points[end].property = PointProperty::concave;
  EXPECT_THAT(marks(identified_items(map)),
              UnorderedElementsAre(Mark::loose_end, Mark::concave_corner, Mark::loose_end));
}

TEST(MapItems, DoorsAreLabelled) {
  Map map;
  add(map, ObjectType::door);
  add(map, ObjectType::possible_door);
  const std::vector<Item> items = identified_items(map);
  EXPECT_THAT(marks(items), ElementsAre(Mark::door, Mark::possible_door))
      << "the ends of doors are no loose ends of walls";
  EXPECT_EQ(items[0].label, "door");
  EXPECT_EQ(items[1].label, "") << "there may be many";
}

TEST(MapItems, TheRobotAndItsSafeDistanceAreNoWalls) {
  Map map;
  add(map, ObjectType::robot);
  add(map, ObjectType::safe_distance);
  add(map, ObjectType::origin);
  EXPECT_THAT(marks(local_map_items(map)), ElementsAre(Mark::origin));
  EXPECT_THAT(marks(robot_items(map)), ElementsAre(Mark::robot, Mark::safe_distance));
}

TEST(MapItems, TheCombinedMapShowsWhatWasFound) {
  Map map;
  for (const char* reason : {"confirmed", "unseen", "contradicted"})
    add(map, ObjectType::wall, reason);
  for (const char* reason : {"open", "shut", "unseen"}) add(map, ObjectType::door, reason);
  add(map, ObjectType::static_obstacle);
  add(map, ObjectType::dynamic_obstacle);
  EXPECT_THAT(marks(combined_map_items(map)),
              ElementsAre(Mark::confirmed_wall, Mark::unseen_wall, Mark::contradicted_wall,
                          Mark::open_door, Mark::shut_door, Mark::unseen_door));
  EXPECT_THAT(marks(obstacle_items(map)),
              ElementsAre(Mark::static_obstacle, Mark::dynamic_obstacle));
}

TEST(MapItems, AnOpenDoorOfTheTrueWorldIsNotThere) {
  Map map;
  add(map, ObjectType::door, "open");
  add(map, ObjectType::door, "shut");
  EXPECT_EQ(true_world_items(map).size(), 1U);
}

TEST(MapItems, ACabinetDrawnAsALineIsClosed) {
  Map map;
  Object cabinet;
  cabinet.type = ObjectType::cabinet;
  cabinet.connection = Connection::closed;
  for (const Vector2& corner : {Vector2(0.0, 0.0), Vector2(1.0, 0.0), Vector2(1.0, 1.0)})
    cabinet.points.push_back(add_point(map, corner));
  map.objects.push_back(cabinet);
  EXPECT_EQ(combined_map_items(map).at(0).points.size(), 4U);
  EXPECT_EQ(global_map_items(map).at(0).points.size(), 3U) << "a polygon closes itself";
}

}  // namespace
}  // namespace perceptor::viewer
