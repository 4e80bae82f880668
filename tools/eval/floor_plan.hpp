/// @file A floor plan of closed outlines, and what can be asked of it.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "common/geometry/segment.hpp"

namespace perceptor {

/// The corners of a closed outline [m]; the last is joined to the first. Free space lies on the
/// left of each side: the outline of a room runs counter-clockwise, that of an obstacle clockwise.
using Outline = std::vector<Vector2>;

/// The first outline encloses the free space; the others stand in it.
struct FloorPlan {
  std::vector<Outline> outlines;
};

/// One side of an outline.
struct PlanWall {
  Segment segment;              ///< [m] world; free space on the left of a to b
  int next = 0;                 ///< index of the wall that begins where this one ends
  bool ends_in_convex = false;  ///< the corner at b sticks out into free space
  std::size_t outline = 0;      ///< index of the one that it is a side of
};

/// Of all outlines, in their order: a wall's index is the number of its edge in the truth.
std::vector<PlanWall> walls(const FloorPlan& plan);

/// The smallest and the largest coordinates [m] of the first outline.
std::pair<Vector2, Vector2> bounds(const FloorPlan& plan);

/// Whether the point lies in free space. The walls themselves belong to neither side.
bool is_free(const FloorPlan& plan, const Vector2& point);

/// [m] from the point to the nearest wall; infinite where there is none.
double clearance(const std::vector<PlanWall>& walls, const Vector2& point);

/// What a floor plan keeps to, so that the truth about it is never a matter of opinion.
struct PlanLimits {
  double min_gap = 0.045;        ///< [m] between walls of one outline that are no neighbours
  double min_passage = 0.15;     ///< [m] between walls of different outlines
  double min_side = 0.045;       ///< [m] of a wall: the thinnest partition ends in one
  double min_turn = 0.26;        ///< [rad] from a wall to the next: less is hardly a corner
  double sharpest_corner = 0.5;  ///< [rad] between a wall and the next
};

/// Whether no two walls cross, touch or come too near each other, every corner is one, and every
/// obstacle stands in the free space.
bool is_sound(const FloorPlan& plan, const PlanLimits& limits = {});

}  // namespace perceptor
