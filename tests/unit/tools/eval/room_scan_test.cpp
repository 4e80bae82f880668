#include "tools/eval/room_scan.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gmock/gmock.h>

#include "tools/eval/room_shapes.hpp"

namespace perceptor {
namespace {

using ::testing::AllOf;
using ::testing::Each;
using ::testing::Ge;
using ::testing::Le;
using ::testing::Lt;

constexpr double kExact = 1e-9;  // [m] far above the rounding of a few metres

/// 4 m by 2 m; the laser stands in its middle and looks along +x.
const FloorPlan kRoom{{rectangle(4.0, 2.0)}};
const Position kMiddle{2.0, 1.0, 0.0};

/// Nine beams over the right half turn and the left, 22.5 degrees apart.
RoomLaser nine_beams() { return {.beams = 9, .fov = std::numbers::pi, .sigma = 0.0}; }

std::vector<TruePiece> pieces_seen(const FloorPlan& plan, const Position& laser_in_world,
                                   const RoomLaser& laser) {
  return scan_room(walls(plan), laser_in_world, laser, 1, 0).pieces;
}

TEST(RoomScan, RangesAreExactWithoutNoise) {
  const LabelledScan scan = scan_room(walls(kRoom), kMiddle, nine_beams(), 1, 0);
  ASSERT_EQ(scan.scan.size(), 9U);
  EXPECT_NEAR(scan.scan.bearings[0], -std::numbers::pi / 2, kExact);
  EXPECT_NEAR(scan.scan.ranges[0], 1.0, kExact);
  EXPECT_NEAR(scan.scan.ranges[2], std::numbers::sqrt2, kExact);
  EXPECT_NEAR(scan.scan.ranges[4], 2.0, kExact);
  EXPECT_NEAR(scan.scan.ranges[8], 1.0, kExact);
}

TEST(RoomScan, PiecesRunFromTheFirstHitOfAWallToTheLast) {
  const auto pieces = pieces_seen(kRoom, kMiddle, nine_beams());
  ASSERT_EQ(pieces.size(), 3U);
  EXPECT_EQ(pieces[0].edge, 0);
  EXPECT_EQ(pieces[0].first_beam, 0U);
  EXPECT_EQ(pieces[0].last_beam, 2U);  // at -45 degrees; the corner lies at -26.6
  EXPECT_EQ(pieces[0].returns, 3U);
  EXPECT_NEAR(distance(pieces[0].segment.a, {0.0, -1.0}), 0.0, kExact);
  EXPECT_NEAR(distance(pieces[0].segment.b, {1.0, -1.0}), 0.0, kExact);
  EXPECT_EQ(pieces[1].edge, 1);
  EXPECT_EQ(pieces[1].first_beam, 3U);
  EXPECT_EQ(pieces[1].last_beam, 5U);
  EXPECT_NEAR(pieces[1].segment.a.x(), 2.0, kExact);
  EXPECT_EQ(pieces[2].edge, 2);
}

TEST(RoomScan, CornersStandWhereTwoPiecesMeet) {
  const LabelledScan scan = scan_room(walls(kRoom), kMiddle, nine_beams(), 1, 0);
  ASSERT_EQ(scan.corners.size(), 2U);
  EXPECT_NEAR(distance(scan.corners[0].location, {2.0, -1.0}), 0.0, kExact);
  EXPECT_NEAR(distance(scan.corners[1].location, {2.0, 1.0}), 0.0, kExact);
  EXPECT_FALSE(scan.corners[0].is_convex);
}

TEST(RoomScan, TruthIsSeenFromTheLaser) {
  const Position turned{1.0, 1.0, std::numbers::pi / 2};  // looks at wall 2, 1 m away
  const auto pieces = pieces_seen(kRoom, turned, {.beams = 3, .fov = 0.2, .sigma = 0.0});
  ASSERT_EQ(pieces.size(), 1U);
  EXPECT_EQ(pieces[0].edge, 2);
  EXPECT_NEAR(distance(pieces[0].segment.a, {1.0, -std::tan(0.1)}), 0.0, kExact);
  EXPECT_NEAR(distance(pieces[0].segment.b, {1.0, std::tan(0.1)}), 0.0, kExact);
}

/// A box stands between the laser and the far wall.
TEST(RoomScan, AnotherWallBetweenMakesTwoPiecesOfOne) {
  const FloorPlan plan{{rectangle(6.0, 6.0), moved(box(1.0, 1.0, 0.0), {4.0, 3.0})}};
  const Position laser_in_world{1.0, 3.0, 0.0};
  const LabelledScan scan =
      scan_room(walls(plan), laser_in_world, {.beams = 101, .fov = 1.0, .sigma = 0.0}, 1, 0);
  ASSERT_EQ(scan.pieces.size(), 3U);
  EXPECT_EQ(scan.pieces[0].edge, 1);
  EXPECT_EQ(scan.pieces[1].edge, 4);  // the box's first, at x = 3.5
  EXPECT_EQ(scan.pieces[2].edge, 1);
  EXPECT_NEAR(scan.pieces[1].segment.a.x(), 2.5, kExact);
  EXPECT_TRUE(scan.corners.empty()) << "of the box's corners one wall is seen only";
}

TEST(RoomScan, ACornerThatSticksOutIsConvex) {
  const FloorPlan plan{{rectangle(6.0, 6.0), moved(box(1.0, 1.0, 0.785), {4.0, 3.0})}};
  const LabelledScan scan =
      scan_room(walls(plan), {1.0, 3.0, 0.0}, {.beams = 501, .fov = 1.0, .sigma = 0.0}, 1, 0);
  ASSERT_EQ(scan.corners.size(), 1U);
  EXPECT_TRUE(scan.corners[0].is_convex);
  EXPECT_TRUE(scan.corners[0].has_to_be_found);
  EXPECT_NEAR(scan.corners[0].location.x(), 3.0 - std::numbers::sqrt2 / 2, 0.001);
}

TEST(RoomScan, NothingIsSeenBeyondTheLargestRange) {
  RoomLaser laser = nine_beams();
  laser.range_max = 1.9;  // short of wall 1, which is 2 m away
  const LabelledScan scan = scan_room(walls(kRoom), kMiddle, laser, 1, 0);
  EXPECT_EQ(scan.scan.ranges[4], 0.0);
  ASSERT_EQ(scan.pieces.size(), 2U);
  EXPECT_TRUE(scan.corners.empty());
}

TEST(RoomScan, ADropoutDoesNotEndAPiece) {
  const auto targets = beam_targets(walls(kRoom), kMiddle, nine_beams());
  const std::vector<bool> returned{true, false, true, true, true, true, true, true, true};
  const auto pieces = true_pieces(targets, returned);
  ASSERT_EQ(pieces.size(), 3U);
  EXPECT_EQ(pieces[0].last_beam, 2U);
  EXPECT_EQ(pieces[0].returns, 2U);
}

TEST(RoomScan, APieceHasToBeFoundFromTenReturnsAndThirtyCentimetres) {
  const auto has_to_be_found = [](std::size_t beams, double length, std::size_t lost) {
    std::vector<std::optional<BeamTarget>> targets;
    for (std::size_t i = 0; i < beams; ++i) {
      const double y = length * static_cast<double>(i) / static_cast<double>(beams - 1);
      targets.push_back(BeamTarget{.wall = 0, .range = 1.0, .location = {1.0, y}});
    }
    std::vector<bool> returned(beams, true);
    for (std::size_t i = 0; i < lost; ++i) returned[2 * i] = false;
    return true_pieces(targets, returned).front().has_to_be_found;
  };
  EXPECT_TRUE(has_to_be_found(10, 0.301, 0));
  EXPECT_FALSE(has_to_be_found(9, 0.301, 0));
  EXPECT_FALSE(has_to_be_found(10, 0.299, 0));
  EXPECT_TRUE(has_to_be_found(12, 0.301, 2));
  EXPECT_FALSE(has_to_be_found(12, 0.301, 3));
}

TEST(RoomScan, ACornerHasToBeFoundWhereBothItsPiecesHaveTo) {
  RoomLaser laser{.beams = 181, .fov = std::numbers::pi, .sigma = 0.0};
  const auto corners_of = [&](const Position& pose) {
    return scan_room(walls(kRoom), pose, laser, 1, 0).corners;
  };
  ASSERT_EQ(corners_of(kMiddle).size(), 2U);
  EXPECT_TRUE(corners_of(kMiddle)[0].has_to_be_found);
  // Looks along -x + y; of wall 0 only its last 5 degrees before the corner are seen.
  laser.fov = 40.0 / 180.0 * std::numbers::pi;
  laser.beams = 41;
  const double corner_bearing = std::atan2(-1.0, 2.0);
  const double twenty_less_five = 15.0 / 180.0 * std::numbers::pi;
  const auto corners = corners_of({2.0, 1.0, corner_bearing + twenty_less_five});
  ASSERT_EQ(corners.size(), 1U);
  EXPECT_FALSE(corners[0].has_to_be_found);
}

TEST(RoomScan, NoCornerBesideAWallOfTwoReturns) {
  const auto all = walls(kRoom);
  std::vector<TruePiece> pieces(2);
  pieces[0] = {.edge = 0, .first_beam = 0, .last_beam = 9, .returns = 10, .segment = {}};
  pieces[1] = {.edge = 1, .first_beam = 10, .last_beam = 12, .returns = 3, .segment = {}};
  EXPECT_EQ(true_corners(all, pieces, kMiddle).size(), 1U);
  pieces[1].returns = 2;
  EXPECT_TRUE(true_corners(all, pieces, kMiddle).empty());
}

/// Many beams on targets 5 m away.
struct Sample {
  explicit Sample(const RoomLaser& laser, std::uint64_t seed = 1)
      : measurement(
            measure(std::vector<std::optional<BeamTarget>>(kBeams, BeamTarget{0, 5.0, {5.0, 0.0}}),
                    laser, seed, 0)) {}

  std::size_t count(double range) const {
    return static_cast<std::size_t>(std::ranges::count(measurement.ranges, range));
  }
  std::size_t count_of_the_target() const {
    return static_cast<std::size_t>(std::ranges::count(measurement.is_of_the_target, true));
  }

  static constexpr std::size_t kBeams = 100'000;
  Measurement measurement;
};

TEST(RoomScanNoise, IsGaussianOfTheGivenWidth) {
  const Sample sample({.sigma = 0.02});
  double sum = 0.0;
  double squares = 0.0;
  double within_one_sigma = 0.0;
  for (const double range : sample.measurement.ranges) {
    sum += range - 5.0;
    squares += (range - 5.0) * (range - 5.0);
    within_one_sigma += std::abs(range - 5.0) < 0.02 ? 1.0 : 0.0;
  }
  const auto n = static_cast<double>(Sample::kBeams);
  // Four standard deviations of each statistic.
  EXPECT_NEAR(sum / n, 0.0, 4.0 * 0.02 / std::sqrt(n));
  EXPECT_NEAR(std::sqrt(squares / n), 0.02, 4.0 * 0.02 / std::sqrt(2.0 * n));
  EXPECT_NEAR(within_one_sigma / n, 0.6827, 4.0 * 0.466 / std::sqrt(n));
}

TEST(RoomScanNoise, OutliersLieAnywhereInTheRangeOfTheLaser) {
  const Sample sample({.sigma = 0.0, .outliers = 0.1});
  double sum = 0.0;
  double outliers = 0.0;
  for (const double range : sample.measurement.ranges)
    if (range != 5.0) {
      sum += range;
      outliers += 1.0;
    }
  EXPECT_NEAR(outliers, 10'000.0, 4.0 * 95.0);
  EXPECT_NEAR(sum / outliers, 5.005, 4.0 * 0.029);
  EXPECT_THAT(sample.measurement.ranges, Each(AllOf(Ge(0.01), Le(10.0))));
  EXPECT_EQ(sample.count_of_the_target(), sample.count(5.0));
}

TEST(RoomScanNoise, DropoutsDoNotReturn) {
  const Sample sample({.sigma = 0.0, .dropouts = 0.1});
  EXPECT_NEAR(static_cast<double>(sample.count(0.0)), 10'000.0, 4.0 * 95.0);
  EXPECT_EQ(sample.count(0.0) + sample.count(5.0), Sample::kBeams);
  EXPECT_EQ(sample.count_of_the_target(), sample.count(5.0));
}

TEST(RoomScanNoise, OneKindDoesNotChangeAnother) {
  const Sample noise({.sigma = 0.02});
  const Sample all({.sigma = 0.02, .outliers = 0.1, .dropouts = 0.1});
  for (std::size_t i = 0; i < Sample::kBeams; ++i)
    if (all.measurement.is_of_the_target[i]) {
      ASSERT_EQ(all.measurement.ranges[i], noise.measurement.ranges[i]);
    }
}

TEST(RoomScanNoise, AClaimedSigmaIsNeverZero) {
  EXPECT_EQ(scan_room(walls(kRoom), kMiddle, nine_beams(), 1, 0).scan.range_sigma, 0.001);
}

TEST(RoomScan, ALaserOfOneBeamIsAnError) {
  EXPECT_THROW(bearings({.beams = 1}), std::invalid_argument);
}

/// Rays at corners and along walls are where exact casting goes wrong.
TEST(RoomScan, EachBeamOfAClosedRoomEndsOnAWall) {
  for (int i = 0; i < 200; ++i) {
    const Position pose{0.5 + 0.015 * i, 1.0, 0.031 * i};
    const auto targets =
        beam_targets(walls(kRoom), pose, {.beams = 721, .fov = 2.0 * std::numbers::pi});
    for (const auto& target : targets) {
      ASSERT_TRUE(target);
      const Segment wall = walls(kRoom)[static_cast<std::size_t>(target->wall)].segment;
      ASSERT_THAT(distance(wall, transform(pose, target->location)), Lt(kExact));
    }
  }
}

}  // namespace
}  // namespace perceptor
