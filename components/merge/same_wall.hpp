/// @file Are two sightings one wall? Parallel within an angle, close, seen from the same side,
/// and overlapping or split in two. The gates follow the uncertainty of both, up to a bound.
#pragma once

#include <optional>

#include "components/merge/wall.hpp"

namespace perceptor::merge {

struct SameWallParameters {
  double offset = 0.05;      ///< [m] walls this close are one however sharp they are; larger
                             ///< loses a flat cabinet before a wall, smaller makes doubles
  double angle = 0.15;       ///< [rad] the same of their angle
  double sigmas = 3.0;       ///< this many standard deviations are added to both
  double max_offset = 0.15;  ///< [m] however uncertain they are
  double max_angle = 0.35;   ///< [rad] however uncertain they are
  double max_gap = 0.3;      ///< [m] pieces further apart stay two: less than any doorway
  double shift = 0.05;       ///< [m] pieces seen in full, moved along by more, are two; larger
                             ///< lets a walking leg leave a trail
};

/// How far two walls differ, the longer one giving the line.
struct Difference {
  double offset = 0.0;  ///< [m] mean distance of the shorter one's ends from the line
  double angle = 0.0;   ///< [rad] at least 0
  double gap = 0.0;     ///< [m] between the nearer ends; 0 where they overlap
  double score = 0.0;   ///< 0: alike; each part relative to what is allowed
};

/// The difference of two walls that may be one; none where they are not. Lines are those of
/// the walls. Pieces with a gap between them are two where one is known to end before it: the walls
/// of two rooms on both sides of a partition. Where beams passed both ends of both to something
/// farther, and both ends lie further on, it is not one wall seen piece by piece, but something
/// that moved. Opposite faces never are one: they run in opposite directions.
std::optional<Difference> compare(const Wall& p, const Line& line_p, const Wall& q,
                                  const Line& line_q, const SameWallParameters& parameters);

/// Whether two walls lie so far apart that they cannot be one, whatever their uncertainty. Quick;
/// false says nothing.
inline bool are_far_apart(const Line& p, const Line& q, const SameWallParameters& parameters) {
  const double reach = (p.length + q.length) / 2.0 + parameters.max_gap + parameters.max_offset;
  return (q.middle - p.middle).squaredNorm() > reach * reach;
}

/// The piece missing between two walls with a gap, along the longer one; none where they
/// overlap.
std::optional<Segment> gap_between(const Line& p, const Line& q);

}  // namespace perceptor::merge
