#include "common/floorplan/floorplan_writer.hpp"

#include <gtest/gtest.h>

#include "tests/unit/common/config/temporary_file.hpp"

namespace perceptor {
namespace {

TEST(FloorplanWriter, WhatIsWrittenIsRead) {
  FloorplanBuilder builder;
  builder.add_wall({{0.0, -0.00001}, {1.0, 0.5}});
  builder.add_wall({{1.0, 0.5}, {2.0, 0.25}});
  builder.add_cabinet({{{0.0, 1.0}, {0.5, 1.0}},
                       {{0.5, 1.0}, {0.5, 1.5}},
                       {{0.5, 1.5}, {0.0, 1.5}},
                       {{0.0, 1.5}, {0.0, 1.0}}});
  builder.add_door({{2.0, 0.25}, {2.0, 1.25}});
  builder.add_start_area({{{3.0, 3.0}, {4.0, 3.0}}, {{4.0, 3.0}, {3.0, 3.0}}});
  EXPECT_EQ(builder.plan().points.size(), 10U) << "points that coincide are one";

  const TemporaryFile file("");
  write_floorplan(builder.plan(), "a \"quoted\" comment", file.path());
  const Floorplan read = read_floorplan(file.path());
  EXPECT_EQ(read.points, builder.plan().points);
  EXPECT_EQ(read.walls, builder.plan().walls);
  EXPECT_EQ(read.cabinets, builder.plan().cabinets);
  EXPECT_EQ(read.doors, builder.plan().doors);
  EXPECT_EQ(read.start_area, builder.plan().start_area);
  EXPECT_TRUE(read.ignored.empty());
}

TEST(FloorplanWriter, SaysWhereItCannotWrite) {
  const TemporaryFile file("");
  EXPECT_THROW(write_floorplan({}, "", file.path() / "below" / "a" / "file"), std::exception);
}

}  // namespace
}  // namespace perceptor
