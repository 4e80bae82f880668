#include "tools/vectorize/trace.hpp"

#include <gtest/gtest.h>

#include "tests/unit/tools/vectorize/drawn_grid.hpp"

namespace perceptor {
namespace {

TEST(Trace, GoesAroundAPillarWithFreeSpaceOnItsLeft) {
  const auto outlines = trace_outlines(drawn({"....",  //
                                              ".##.",  //
                                              "...."}),
                                       0);
  ASSERT_EQ(outlines.size(), 1U);
  EXPECT_TRUE(outlines.front().is_closed);
  ASSERT_EQ(outlines.front().places.size(), 6U);
  double area = 0.0;
  const auto& places = outlines.front().places;
  for (std::size_t i = 0; i < places.size(); ++i)
    area += cross(places[i], places[(i + 1) % places.size()]) / 2.0;
  EXPECT_LT(area, 0.0) << "clockwise around what is occupied";
}

TEST(Trace, LeavesOutWhatFacesTheUnknown) {
  const auto outlines = trace_outlines(drawn({"    ",  //
                                              "####",  //
                                              "...."}),
                                       0);
  ASSERT_EQ(outlines.size(), 1U);
  EXPECT_FALSE(outlines.front().is_closed);
  EXPECT_EQ(outlines.front().places.size(), 4U);
  for (const Vector2& place : outlines.front().places) EXPECT_DOUBLE_EQ(place.y(), 0.1);
}

TEST(Trace, UnknownCellsBetweenFreeAndOccupiedAreReachedOver) {
  const auto grid = drawn({"####",  //
                           "    ",  //
                           "...."});
  EXPECT_TRUE(trace_outlines(grid, 0).empty());
  EXPECT_EQ(trace_outlines(grid, 1).size(), 1U);
}

TEST(Trace, CellsThatTouchAtACornerAreJoined) {
  const auto outlines = trace_outlines(drawn({".....",  //
                                              "...#.",  //
                                              "..#..",  //
                                              ".#...",  //
                                              "....."}),
                                       0);
  ASSERT_EQ(outlines.size(), 1U);
  EXPECT_EQ(outlines.front().places.size(), 12U);
}

TEST(Trace, NothingOccupiedHasNoOutline) {
  EXPECT_TRUE(trace_outlines(drawn({"...", "   "}), 2).empty());
  EXPECT_TRUE(trace_outlines({}, 2).empty());
}

}  // namespace
}  // namespace perceptor
