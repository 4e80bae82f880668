#include "tools/eval/room_set.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include <gmock/gmock.h>

#include "tools/eval/scan_set_writer.hpp"

namespace perceptor {
namespace {

std::string text(const ScanSet& set) {
  std::ostringstream out;
  write_scans(out, set);
  write_truth(out, set);
  return out.str();
}

TEST(RoomSet, TheSameSeedGivesTheSameBytes) {
  const RoomScanParameters parameters{
      .scans = 14, .laser = {.outliers = 0.02, .dropouts = 0.02}, .seed = 5};
  EXPECT_EQ(text(make_room_scans(parameters)), text(make_room_scans(parameters)));
}

TEST(RoomSet, AnotherSeedGivesOtherRooms) {
  const ScanSet one = make_room_scans({.scans = 1, .seed = 1});
  const ScanSet other = make_room_scans({.scans = 1, .seed = 2});
  EXPECT_NE(one.scans[0].laser_in_world, other.scans[0].laser_in_world);
  EXPECT_NE(one.scans[0].scan.ranges, other.scans[0].scan.ranges);
}

TEST(RoomSet, MoreScansBeginWithTheSameOnes) {
  ScanSet more = make_room_scans({.scans = 12});
  more.scans.resize(7);
  EXPECT_EQ(text(more), text(make_room_scans({.scans = 7})));
}

TEST(RoomSet, NoiseChangesNeitherRoomsNorPlaces) {
  const ScanSet clean = make_room_scans({.scans = 7, .laser = {.sigma = 0.0}});
  const ScanSet noisy = make_room_scans({.scans = 7, .laser = {.sigma = 0.03, .outliers = 0.1}});
  for (std::size_t i = 0; i < 7; ++i) {
    EXPECT_EQ(clean.scans[i].laser_in_world, noisy.scans[i].laser_in_world);
    ASSERT_EQ(clean.scans[i].pieces.size(), noisy.scans[i].pieces.size());
    EXPECT_EQ(clean.scans[i].pieces[0].segment.a, noisy.scans[i].pieces[0].segment.a);
  }
}

TEST(RoomSet, EachScanSeesWallsAndHasTruth) {
  const ScanSet set = make_room_scans({.scans = 70});
  EXPECT_TRUE(set.has_truth);
  ASSERT_EQ(set.scans.size(), 70U);
  for (const LabelledScan& scan : set.scans) {
    EXPECT_EQ(scan.scan.size(), 1000U);
    EXPECT_TRUE(std::ranges::any_of(scan.pieces, &TruePiece::has_to_be_found));
  }
}

/// Written down, since sets of one seed that were scored on different days are compared.
TEST(RoomSet, SeedOneGivesWhatItGave) {
  RoomRandom random = make_room_stream(1, 0, RoomStream::plan);
  EXPECT_DOUBLE_EQ(uniform(random, 0.0, 1.0), 0.7447926653529775);
  EXPECT_EQ(uniform_int(random, 1, 6), 3);
  EXPECT_NEAR(normal(random), 1.3682694070529648, 1e-12);

  const ScanSet set = make_room_scans({.scans = 7});
  const Position last = set.scans.back().laser_in_world;
  EXPECT_NEAR(last.x, 1.25259, 1e-5);
  EXPECT_NEAR(last.y, 0.82080, 1e-5);
  EXPECT_NEAR(last.a, 1.380420, 1e-6);
  std::size_t pieces = 0;
  for (const LabelledScan& scan : set.scans) pieces += scan.pieces.size();
  EXPECT_EQ(pieces, 64U);
}

TEST(RoomSet, NoKindsAreAnError) {
  EXPECT_THROW(make_room_scans({.scans = 1, .kinds = {}}), std::invalid_argument);
}

}  // namespace
}  // namespace perceptor
