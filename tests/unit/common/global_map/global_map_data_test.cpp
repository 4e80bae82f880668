/// @file The maps of others, found in PERCEPTOR_DATA or beside the source tree.
#include <algorithm>

#include <gtest/gtest.h>

#include "common/floorplan/floorplan.hpp"
#include "common/global_map/global_map.hpp"
#include "tests/support/recorded_data.hpp"

namespace perceptor::global_map {
namespace {

Map map_of(const char* name) {
  return make_global_map(read_floorplan(*testing::recorded(name))).map;
}

auto count(const Map& map, ObjectType type) {
  return std::ranges::count(map.objects, type, &Object::type);
}

TEST(RecordedMaps, HospitalOf2019) {
  PERCEPTOR_REQUIRE_RECORDED("maps/hospital_2019.json");
  const Map map = map_of("maps/hospital_2019.json");
  EXPECT_EQ(count(map, ObjectType::wall), 40);
  EXPECT_EQ(count(map, ObjectType::cabinet), 4);
  for (const Point& point : map.points)
    EXPECT_TRUE(point.property == PointProperty::convex ||
                point.property == PointProperty::concave);
}

TEST(RecordedMaps, WhatStudentsAddedChangesNothing) {
  PERCEPTOR_REQUIRE_RECORDED("maps/hospital_2019_with_nodes.json");
  const auto id_of = [](const char* name) {
    return make_global_map(read_floorplan(*testing::recorded(name))).id;
  };
  EXPECT_EQ(id_of("maps/hospital_2019_with_nodes.json"), id_of("maps/hospital_2019.json"));
}

TEST(RecordedMaps, CabinetsThatCloseTheWalls) {
  for (const char* name : {"maps/open_chains.json", "maps/emc_example.json"}) {
    PERCEPTOR_REQUIRE_RECORDED(name);
    const Map map = map_of(name);
    const Vector2 centre = [&] {
      Vector2 sum = Vector2::Zero();
      for (const Point& point : map.points) sum += point.location;
      return Vector2(sum / static_cast<double>(map.points.size()));
    }();
    // The outer walls look inwards.
    for (const Object& object : map.objects) {
      if (object.type != ObjectType::wall) continue;
      const Segment s = segment(map, object);
      const bool is_outer = length(s) > 2.0;
      EXPECT_TRUE(!is_outer || signed_distance(s, centre) > 0.0) << name << " " << s.a.transpose();
    }
  }
}

}  // namespace
}  // namespace perceptor::global_map
