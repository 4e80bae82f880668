#include "common/model/map_parts.hpp"

#include <utility>

#include <gtest/gtest.h>

namespace perceptor {
namespace {

TEST(Parts, SmallMapIsOne) {
  Map map;
  add_segment(map, {{0.0, 0.0}, {1.0, 0.0}}, ObjectType::wall);
  EXPECT_EQ(parts_of(map, 10, 10).size(), 1U);
  EXPECT_EQ(parts_of({}, 10, 10).size(), 1U);
}

TEST(Parts, HoldEachObjectOnce) {
  Map map;
  for (int i = 0; i < 7; ++i) {
    const Index wall = add_segment(map, {{1.0 * i, 0.0}, {i + 1.0, 0.0}}, ObjectType::wall);
    map.objects[static_cast<std::size_t>(wall)].id = i;
    if (i > 0) connect(map, 2 * i - 1, 2 * i);
  }
  for (const auto& [objects, points] : {std::pair{3U, 100U}, std::pair{100U, 6U}}) {
    const std::vector<Map> parts = parts_of(map, objects, points);
    ASSERT_EQ(parts.size(), 3U);
    std::int32_t next = 0;
    for (const Map& part : parts) {
      EXPECT_EQ(find_broken_reference(part), "");
      for (const Object& object : part.objects) EXPECT_EQ(object.id, next++);
    }
    EXPECT_EQ(next, 7);
    EXPECT_EQ(parts[1].points.front().connected, kNone) << "its partner is in another part";
    EXPECT_NE(parts[1].points[1].connected, kNone);
  }
}

TEST(Parts, ObjectWithMorePointsThanAPartHasOneForItself) {
  Map map;
  map.objects.resize(2);
  for (Index object : {0, 1})
    for (int i = 0; i < 5; ++i) {
      const Index point = add_point(map, {1.0 * i, 1.0 * object});
      map.points[static_cast<std::size_t>(point)].parents = {object};
      map.objects[static_cast<std::size_t>(object)].points.push_back(point);
    }
  EXPECT_EQ(parts_of(map, 10, 3).size(), 2U);
}

}  // namespace
}  // namespace perceptor
