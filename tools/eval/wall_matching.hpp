/// @file Which found wall is which true one.
///
/// A wall lies on a true piece where the angle between them and the distance of the piece's
/// middle from the wall's line are small, and half of the wall or more overlaps the pieces of
/// that edge. It matches the piece where it covers half of it as well. Pairs are taken by
/// overlap, the longest first; a piece has one wall, a wall may have several pieces of one edge.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "tools/eval/scan_set.hpp"

namespace perceptor {

struct WallMatchParameters {
  double max_angle = 0.0872664626;  ///< [rad] between wall and piece, 5 degrees
  double max_offset = 0.10;         ///< [m] of the piece's middle from the wall's line
  double min_share_of_piece = 0.5;  ///< [-] that the wall covers
  double min_share_of_wall = 0.5;   ///< [-] that overlaps the edge's pieces
};

enum class WallVerdict {
  matched,   ///< a piece that has to be found
  neutral,   ///< a piece that does not, or lies on one: counts neither way
  fragment,  ///< lies on a piece that has to be found, and is not its match
  nothing,   ///< lies on no piece
};

struct WallMatching {
  std::vector<WallVerdict> verdicts;                       ///< one for each wall
  std::vector<std::optional<std::size_t>> wall_of_pieces;  ///< one for each piece
};

WallMatching match_walls(const std::vector<TruePiece>& pieces, const std::vector<Segment>& walls,
                         const WallMatchParameters& parameters);

}  // namespace perceptor
