/// @file The local map with its corners typed and its doors named. One map in, one map out:
/// nothing is remembered, so what is stable is so because the geometry is.
#pragma once

#include "components/identify/corner_types.hpp"
#include "components/identify/openings.hpp"

namespace perceptor::identify {

struct IdentifyParameters {
  CornerTypeParameters corners;
  OpeningParameters openings;
  ConfidenceParameters confidence;
};

/// Types the corners (corner_types.hpp), and appends an object of two new points for each door
/// and possible door (openings.hpp), in that order, each kind by falling confidence; gives the
/// number appended. `robot`: [m] in the map's frame.
///
/// A turned end that bounds a door is the corner of its jamb, and becomes convex.
///
/// Of such an object: point 0 to 1 has the free side on its left; each point's projection is
/// the wall's end that it comes from (none on the face of a wall), of which it has covariance
/// and weight; first_seen is when both walls had been seen, last_seen when both still were.
std::size_t identify(Map& map, const Vector2& robot, const IdentifyParameters& parameters = {});

/// Takes the last appended object and its two points out again.
void remove_last_opening(Map& map);

}  // namespace perceptor::identify
