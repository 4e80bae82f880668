/// @file Outlines as map files draw them: sides in any order and direction.
#pragma once

#include <optional>
#include <vector>

#include "common/floorplan/floorplan.hpp"

namespace perceptor {

/// Points of a file that are nearer to each other than this [m] are one corner of an outline.
inline constexpr double kSameCorner = 0.005;

/// The corners of an outline in order [m], beginning with the two of its first side; the last
/// joins the first, whether that side is drawn or not (a cabinet's back, at the wall). None
/// where the sides are not one line that meets itself at most in its ends.
std::optional<std::vector<Vector2>> find_corners(const Floorplan& plan,
                                                 const std::vector<Floorplan::Edge>& outline);

/// The same of an outline that read_floorplan has checked: every cabinet. Throws
/// std::bad_optional_access for any other.
std::vector<Vector2> corners(const Floorplan& plan, const std::vector<Floorplan::Edge>& outline);

/// What a door closes: the longest of its edges. A file draws a door as one line, or as the
/// outline of its leaf.
Segment opening(const Floorplan& plan, const std::vector<Floorplan::Edge>& door);

}  // namespace perceptor
