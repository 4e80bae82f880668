/// @file Corners of the current map, and the ways in which they are seen.
///
///   intersection: the lines of two walls that follow each other meet close to the end of both;
///   spike: a jump in range, the nearer point is an outer corner;
///   vector: the direction turns between two neighbours, one of which is no wall.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "common/model/map.hpp"
#include "components/scan/walls.hpp"

namespace perceptor::scan {

inline constexpr std::size_t kNoWall = std::numeric_limits<std::size_t>::max();

/// What a run of beams shows.
struct RunResult {
  Run run;
  Verdict verdict = Verdict::wall;
  std::size_t wall = kNoWall;  ///< index into the walls, where the verdict is `wall`
};

struct Corner {
  WallEnd place;
  CornerMethod method = CornerMethod::none;
  /// Convex sticks out into free space, concave is the inside of a room's corner. Floating:
  /// one side is too short for its direction to be known.
  PointProperty property = PointProperty::floating;
  std::size_t before = kNoWall;  ///< the wall that ends at it, if one does
  std::size_t after = kNoWall;   ///< the wall that begins at it, if one does
  std::size_t beam = 0;          ///< that shows it, index into Beams
};

/// Looks at the cuts between runs that follow each other; one corner for each cut at most, in
/// their order.
void find_corners(const std::vector<RunResult>& runs, const std::vector<Wall>& walls,
                  const Beams& beams, const ScanParameters& parameters,
                  std::vector<Corner>& corners);

}  // namespace perceptor::scan
