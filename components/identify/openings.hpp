/// @file Doors and possible doors: openings between walls that stand in about one line.
///
/// What bounds an opening is the end of a wall, or its face:
///
/// - a corner: convex, its two walls connected;
/// - an outer end: convex, seen from one side only (corner_types.hpp, rule 4);
/// - a turned end: floating, but the surface was seen to turn there into something too short
///   to be a wall. Across from another end in its line that can only be the jamb of a doorway;
/// - a loose end: floating, so the wall may go on unseen;
/// - a face: the inside of a wall that an end without a corner looks at squarely.
///
/// Two ends that are convex or turned make a door. A loose end with any other, or an end and a
/// face, make a possible door. Concave corners bound nothing, nor does the far end of a jamb,
/// which is the depth of a wall and no wall of its own.
///
/// 1. Pair the ends: the width within limits; each wall points away from the opening, within
///    an angle of the line through the two ends; each end is near the line of the other wall;
///    both walls are free on the same side.
///    Or, for a doorway that is seen from within and whose walls are hidden: two walls that
///    face each other end together, one at least with an outer end, and not both so long that
///    they are a corridor's. What is hidden behind the two ends is taken to be in line.
/// 2. Take out those that are shut: a wall crosses the opening, or stands across a good part
///    of it close behind or before (a shut door that stands back).
/// 3. Give each a confidence, and choose the best first, doors before possible doors. Each
///    end, and each corner, is used once.
/// 4. One opening is one door: where both faces of a thick wall show, the face nearer to the
///    robot stays. A possible door that overlaps a door, or a better possible door, goes.
#pragma once

#include <string_view>
#include <vector>

#include "common/model/map.hpp"
#include "components/identify/walls.hpp"

namespace perceptor::identify {

struct OpeningParameters {
  double door_min_width = 0.47;  ///< [m] less takes gaps that no robot drives through
  double door_max_width = 1.53;  ///< [m] more takes the ends of corridors
  double wall_min_length = 0.2;  ///< [m] shorter walls bound nothing: their direction is unsure
  double max_angle = 0.26;       ///< [rad] of each wall with the line through the two ends
  double max_offset = 0.15;      ///< [m] of each end from the line of the other wall
  double max_face_angle = 0.35;  ///< [rad] by which an end's wall may miss the normal of a face, or
                                 ///< of the line between two jambs
  double max_jamb_length = 1.2;  ///< [m] of the shorter of two jambs between which the robot
                                 ///< stands; more takes the ends of corridors
  double end_tolerance = 0.1;    ///< [m] along the opening, from each end, where a wall that
                                 ///< only touches the line does not shut it (a jamb); for a
                                 ///< face also how far its own ends must be
  double shut_depth_behind = 0.4;   ///< [m] a wall across the opening this close behind its walls'
                                    ///< faces shuts it; more loses doors onto narrow corridors
  double shut_depth_before = 0.1;   ///< [m] the same before the faces
  double shut_share = 0.3;          ///< [-] of the width that such a wall must stand across
  double max_wall_thickness = 0.4;  ///< [m] between the two faces of one wall; more takes two
                                    ///< doors behind each other for one
};

/// How a confidence is made. It is the product of
/// - a factor for each of the two bounds, by its kind;
/// - `one_side_unknown` where the free side of a wall is not known;
/// - 1 less three shares, each in proportion to how much of its limit is used up: the larger
///   angle of max_angle (of a face: max_face_angle), the larger offset of max_offset, and the
///   width's distance from the usual width, of the distance between that and the limit.
/// A usual door between two corners in one line has 1.
struct ConfidenceParameters {
  double outer_end = 0.8;         ///< [-] factor for an end that was seen from one side only
  double turned_end = 0.7;        ///< [-] factor for an end that turns into no wall
  double loose_end = 0.5;         ///< [-] factor for an end that may not be one
  double face = 0.5;              ///< [-] factor for the face of a wall
  double one_side_unknown = 0.8;  ///< [-] factor where it is not sure that both walls face alike
  double angle_share = 0.3;       ///< [-] lost at the limit of the angle
  double offset_share = 0.3;      ///< [-] lost at the limit of the offset
  double width_share = 0.2;       ///< [-] lost at the limits of the width
  double usual_width = 0.9;       ///< [m] within the limits of the width
};

/// One side of an opening.
struct OpeningBound {
  Vector2 location = Vector2::Zero();  ///< [m] map frame
  Index point = kNone;                 ///< the wall's end in Map::points; none: on a face
  Index wall = kNone;                  ///< in Map::objects
};

/// A door or a possible door.
struct Opening {
  ObjectType type = ObjectType::possible_door;  ///< door or possible_door
  OpeningBound first;   ///< the free side is left of the way from first to second;
  OpeningBound second;  ///< where it is not known, the robot is
  FreeSide free_side = FreeSide::unknown;  ///< left or unknown
  double confidence = 0.0;                 ///< 0 to 1
  std::string_view reason;                 ///< what bounds it; a fixed text
};

/// The doors and possible doors of a map whose corners have their types. Doors come first,
/// each kind by falling confidence. `walls`: read_walls(map). `robot`: [m] in the map's frame.
std::vector<Opening> find_openings(const Map& map, const std::vector<Wall>& walls,
                                   const Vector2& robot, const OpeningParameters& parameters = {},
                                   const ConfidenceParameters& confidence = {});

}  // namespace perceptor::identify
