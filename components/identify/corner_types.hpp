/// @file Convex or concave: what each corner of a map is, as the robot sees it.
///
/// A corner is where the ends of two walls are connected. It is convex where the solid takes
/// up less than half of the turn around it (the edge of a pillar or of a doorway), concave
/// where the free space does (the inside of a room's corner).
///
/// 1. The free sides decide, not where the robot happens to stand: a corner is convex for a
///    wall whose free side looks away from the other wall, concave where it looks towards it.
///    So the type stays as it is while the robot drives around the corner.
/// 2. Where neither free side is known, or the two contradict each other, the robot's place
///    decides: concave when the robot is between the two walls, convex otherwise.
/// 3. Two walls that go on nearly straight are no corner: they stay "connected". Two that
///    fold back on each other are convex where each is free on its own side (the end of a thin
///    partition).
/// 4. A loose end seen as the nearer side of a jump in range is an outer corner too, of which
///    the second face is hidden: the laser looked past it and saw what is further away, so the
///    wall does end there. It becomes convex, and stays unconnected, which tells it apart. The
///    end of a wall that something else hides lies on the far side of its jump, and stays
///    floating.
#pragma once

#include <vector>

#include "common/model/map.hpp"
#include "components/identify/walls.hpp"

namespace perceptor::identify {

struct CornerTypeParameters {
  /// [rad] Two walls that turn by less are no corner; more leaves flat corners without a type.
  double straight_angle = 0.1;
  /// Rule 4; off: such an end stays floating, and is worth what any loose end is.
  bool jump_is_convex = true;
};

/// Gives each corner of the map its type, in place. `walls`: read_walls(map). `robot`: [m] in
/// the map's frame. An end marked connected whose partner is not the end of another wall is
/// floating again.
void classify_corners(Map& map, const std::vector<Wall>& walls, const Vector2& robot,
                      const CornerTypeParameters& parameters = {});

}  // namespace perceptor::identify
