/// @file Corners of the current map, and the ways in which they are seen.
///
///   intersection: the lines of two walls that follow each other meet close to the end of both;
///   spike: a jump in range, the nearer point is an outer corner;
///   vector: the direction turns between two neighbours, one of which is no wall.
#pragma once

#include <optional>
#include <vector>

#include "common/model/map.hpp"
#include "components/scan/walls.hpp"

namespace perceptor::scan {

/// What was seen of the two ends of a wall.
struct WallCorners {
  CornerMethod first = CornerMethod::none;
  CornerMethod last = CornerMethod::none;
};

/// A corner that no wall ends in.
struct LoneCorner {
  WallEnd place;
  CornerMethod method = CornerMethod::none;
  std::size_t beam = 0;  ///< the beam that shows it
};

struct Corners {
  std::vector<WallCorners> of_walls;  ///< one for each run; none where it shows no wall
  std::vector<LoneCorner> lone;
};

/// Looks at the cuts between runs that follow each other. Ends of walls that meet in an
/// intersection are moved there, with its covariance. `walls[i]` is what run i shows.
Corners find_corners(const std::vector<Run>& runs, std::vector<std::optional<Wall>>& walls,
                     const Beams& beams, const ScanParameters& parameters);

}  // namespace perceptor::scan
