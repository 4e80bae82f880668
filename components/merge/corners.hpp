/// @file Walls that meet: the head of one and the tail of the next become a corner.
#pragma once

#include <vector>

#include "components/merge/wall.hpp"

namespace perceptor::merge {

struct CornerParameters {
  double min_angle = 0.35;   ///< [rad] below it two lines do not fix a corner: their ends do
  double max_step = 0.05;    ///< [m] nearly parallel walls further apart sideways are a step in
                             ///< the wall, not a corner
  double max_hole = 0.1;     ///< [m] nor are those whose ends are further apart: more closes what
                             ///< may be an opening
  double keep_radius = 0.3;  ///< [m] a corner whose walls part further comes undone
};

/// Connects the ends that lie within their radius of a corner, the nearest first and those that
/// were connected before all others; takes back connections that no longer hold. An end that was
/// seen as one, with something farther behind it, is not prolonged to a wall behind. Connected
/// ends are moved onto the corner: where the two lines meet, or, where they are nearly
/// parallel, between the ends according to their weights. The two faces at the end of a thin
/// wall are no corner. `walls` have distinct ids in increasing order.
void connect_corners(std::vector<Wall>& walls, const CornerParameters& parameters,
                     const EndParameters& ends);

}  // namespace perceptor::merge
