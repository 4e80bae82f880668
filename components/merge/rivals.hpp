/// @file Two walls of the map that cannot both be there: free on the same side and the one closely
/// behind the other without a back between them, so that nobody could have seen the one behind.
/// They come from a pose that drifted, from a recess that was seen at a grazing angle before it was
/// looked into, from something flat that was put before a wall. What was seen last is right, once
/// it was seen steadily; until then the wall that is known stays, and the other one waits.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "components/merge/sees_through.hpp"
#include "components/merge/wall.hpp"

namespace perceptor::merge {

struct RivalParameters {
  double max_distance = 0.3;    ///< [m] between the two; more leaves room for two walls
  double max_angle = 0.25;      ///< [rad] between the two
  double min_overlap = 0.2;     ///< [m] along the wall; less is a joint of two pieces
  double min_thickness = 0.05;  ///< [m] of what has a back: two walls can be there then
  int min_beams = 5;            ///< of the scan that ended on the rival there; a wall seen at a
                                ///< grazing angle has few before a recess
};

/// What one scan saw of a wall.
struct Observation {
  std::int32_t wall = kNone;  ///< id of the wall that it became part of
  Segment segment;            ///< [m] local frame
  std::int32_t support = 0;   ///< beams
};

/// A piece of a wall in whose place the scan saw another one, its rival.
struct Contradiction {
  std::size_t wall = 0;
  std::size_t rival = 0;
  Interval piece;  ///< [m] from the tail of the wall
};

/// What the scan taken from `laser` (local frame) has against the walls of the map, in the order of
/// the walls. It has nothing against a piece that it saw as well.
std::vector<Contradiction> contradictions(const std::vector<Wall>& walls,
                                          const std::vector<Observation>& seen,
                                          const Vector2& laser, const RivalParameters& parameters);

/// A sighting that was matched with the wall `known`, cut off where it goes on beyond that wall
/// into the place of another confirmed one. `lines` are those of the walls.
Wall clear_of_rivals(const Wall& sighted, std::size_t known, const std::vector<Wall>& walls,
                     const std::vector<Line>& lines, const RivalParameters& parameters);

/// What confirmed walls leave of the place of another one, in metres from its tail: the longest
/// piece, or an empty one.
Interval free_piece(const Wall& wall, const std::vector<Wall>& walls,
                    const RivalParameters& parameters);

}  // namespace perceptor::merge
