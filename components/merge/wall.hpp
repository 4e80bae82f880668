/// @file A wall as merge keeps it: an oriented line with its uncertainty, two ends, and what
/// speaks for it. Free space lies on the left of a to b, so two faces of one partition run in
/// opposite directions, and along the free side the end b of one wall meets the end a of the
/// next.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "common/geometry/line.hpp"
#include "common/model/map.hpp"

namespace perceptor::merge {

/// The ends of a wall, in the order of Segment.
inline constexpr std::size_t kTail = 0;  ///< segment.a
inline constexpr std::size_t kHead = 1;  ///< segment.b

struct WallEnd {
  CornerMethod method = CornerMethod::none;  ///< none: seen up to here, it may go on
  double variance = 0.0;                     ///< [m^2] of its place along the wall
  double radius = 0.0;                       ///< [m] within which it becomes part of a corner
  int overshoots = 0;                        ///< sightings that went on beyond a known end
  std::int32_t connected = kNone;  ///< id of the wall that forms a corner with this end: a
                                   ///< head always meets a tail
};

struct EndParameters {
  double min_sigma = 0.001;  ///< [m] no end is known better; larger lets one bad scan move a
                             ///< corner
  double min_radius = 0.1;   ///< [m] the radius of a well known end shrinks to this
  double seen_reach = 0.03;  ///< [m] a corner may lie this far from an end that was seen as one;
                             ///< larger joins furniture to the wall behind
};

struct Wall {
  std::int32_t id = kNone;
  Segment segment;  ///< [m] free space on its left
  /// Of the line at the middle of the segment: offset to the left [m], angle [rad].
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
  std::array<WallEnd, 2> ends;
  std::int32_t support = 0;     ///< beams behind it in the last scan that saw it
  int sightings = 1;            ///< scans that saw it
  int scans = 1;                ///< scans since it was first seen
  double weight = 1.0;          ///< sightings, bounded, halved by each scan that sees through it
  std::int64_t first_seen = 0;  ///< [us]
  std::int64_t last_seen = 0;   ///< [us]
  bool confirmed = false;       ///< else tentative, and not published
  bool is_new = false;          ///< confirmed by the last scan
  bool doubted = false;    ///< seen through, or another wall seen in its place, by the last scan
  bool contested = false;  ///< stands in the place of a confirmed wall, and has to wait
  bool remove = false;     ///< taken out at the end of the step
};

/// The covariance of a line, moved `along` metres along it.
Eigen::Matrix2d moved_along(const Eigen::Matrix2d& covariance, double along);

/// [m^2] of an end: across the wall its line says how well it is known, along it the end itself.
/// `line` is the wall's, in the frame that is asked for.
Eigen::Matrix2d end_covariance(const Wall& wall, const Line& line, std::size_t end);

/// Moves the ends of a wall. Its line covariance follows the middle.
void set_ends(Wall& wall, const Segment& segment);

bool is_known(const WallEnd& end);

/// The wall does not go on there: beams passed it to something farther, or the surface was seen to
/// turn into something too small for a wall.
bool is_seen_as_end(const WallEnd& end);

/// [m] how far an end that is seen as one may be from the corner that it belongs to: the wall
/// may go on behind its last beam, as its variance says.
double reach_of_seen(const WallEnd& end, const EndParameters& parameters);

/// Gives an end a smaller variance, within bounds; its radius shrinks as its standard
/// deviation does.
void sharpen(WallEnd& end, double variance, const EndParameters& parameters);

/// Removes what is marked, and the corners that it was part of.
void remove_marked(std::vector<Wall>& walls);

}  // namespace perceptor::merge
