/// @file The map: points, and objects that refer to them. References are indices, never
/// pointers, so that a map can be copied, grown, sent and compared.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "common/geometry/segment.hpp"

namespace perceptor {

/// An index into Map::points or Map::objects.
using Index = std::int32_t;
inline constexpr Index kNone = -1;

/// What a point is known to be. Convex sticks out towards the robot's free space, concave
/// is the inside of a room's corner.
enum class PointProperty : std::int8_t { floating, connected, convex, concave };

/// How a corner was seen.
enum class CornerMethod : std::int8_t { none, spike, vector, intersection, map };

enum class ObjectType : std::int8_t {
  wall,
  door,
  possible_door,
  cabinet,
  origin,
  robot,
  dynamic_obstacle,
  static_obstacle,
  safe_distance,
  test,
  start_area
};

enum class DrawType : std::int8_t { points, lines };
enum class Connection : std::int8_t { open, closed };

/// The side from which a wall was seen, looking from its first point to its second.
enum class FreeSide : std::int8_t { right = -1, unknown = 0, left = 1 };

inline constexpr std::size_t kMaxNameLength = 15;

struct Point {
  Vector2 location = Vector2::Zero();         ///< [m] in the map's frame
  std::optional<Eigen::Matrix2d> covariance;  ///< [m^2] of the location
  PointProperty property = PointProperty::floating;
  CornerMethod method = CornerMethod::none;
  double radius = 0.0;         ///< [m] within which it connects to another wall's end
  double weight = 0.0;         ///< how certain the location is
  Index connected = kNone;     ///< end of another wall that forms the corner with it
  Index projection = kNone;    ///< point it lies on top of after merging
  std::vector<Index> parents;  ///< objects that it belongs to; none: a lone corner
};

struct Object {
  std::int32_t id = kNone;  ///< stays with the object from map to map
  std::string name;         ///< at most kMaxNameLength characters
  ObjectType type = ObjectType::wall;
  DrawType draw_type = DrawType::lines;
  Connection connection = Connection::open;
  std::int32_t colour = 0;  ///< 0xRRGGBB
  bool remove = false;      ///< taken out by the next remove_objects
  bool is_new = true;       ///< added since the last set_objects_old
  FreeSide free_side = FreeSide::unknown;
  std::int32_t support = 0;  ///< beams behind it in the last scan that saw it
  double weight = 0.0;       ///< how certain it is
  double confidence = 0.0;   ///< 0 to 1; of doors and possible doors
  /// Of the line through it, at its middle: perpendicular offset [m], angle [rad].
  std::optional<Eigen::Matrix2d> line_covariance;
  std::int64_t first_seen = 0;  ///< [us] utime of the first scan that saw it; 0: unknown
  std::int64_t last_seen = 0;   ///< [us] utime of the last scan that saw it; 0: unknown
  std::string reason;           ///< why it was formed, for people
  std::vector<Index> points;    ///< two for walls and doors
};

/// Thrown by the functions that need an object of exactly two points.
class NotASegment : public std::invalid_argument {
 public:
  explicit NotASegment(const Object& object);
};

struct Map {
  std::vector<Point> points;
  std::vector<Object> objects;
};

/// Adds a point without parents; gives its index.
Index add_point(Map& map, const Vector2& location);

/// Adds an object of two new points; gives the object's index. Its points have the object
/// as their parent. A name that is too long is cut.
Index add_segment(Map& map, const Segment& segment, ObjectType type, std::string_view name = {});

/// The two points of an object. Throws NotASegment for any other number of points.
Segment segment(const Map& map, const Object& object);
Segment segment(const Map& map, Index object);

/// Where an object's points are, in order [m].
std::vector<Vector2> corners(const Map& map, const Object& object);

/// The straight pieces of an object in order, the closing one of a closed one included.
std::vector<Segment> edges(const Map& map, const Object& object);

/// Moves the ends of a two-point object. Throws NotASegment as above.
void set_segment(Map& map, Index object, const Segment& segment);

// What can be said of one or two objects of two points; see segment.hpp for the meaning.
// All throw NotASegment.
double angle(const Map& map, const Object& object);
double length(const Map& map, const Object& object);
double smallest_relative_angle(const Map& map, const Object& first, const Object& second);
double angle_between(const Map& map, const Object& first, const Object& second);
double average_perpendicular_distance(const Map& map, const Object& first, const Object& second);
double gap_distance(const Map& map, const Object& first, const Object& second);

/// Moves the points of one object: first rotate, then translate. Any number of points.
void transform(Map& map, const Object& object, const Position& map_in_new);

/// Whether two points belong to one object.
bool same_parent_object(const Map& map, Index first, Index second);

/// Makes two points each other's connected point, and both connected.
void connect(Map& map, Index first, Index second);

/// Takes back a connection from both ends; each becomes floating again.
void disconnect(Map& map, Index point);

/// The whole map, seen from another frame: locations and covariances are rotated, then
/// translated.
Map transform(const Map& map, const Position& map_in_new);

/// Takes out the objects marked `remove`, and the points that belonged to removed objects
/// only. All references that remain are renumbered; references to what went become kNone,
/// and a point that loses its connected point becomes floating.
void remove_objects(Map& map);

/// Clears `is_new` on every object.
void set_objects_old(Map& map);

/// One line for each object, for people.
void print(std::ostream& out, const Map& map);

/// Every reference points at something that is there, and points and objects agree about
/// who belongs to whom. Says what is wrong; empty: nothing.
std::string find_broken_reference(const Map& map);

}  // namespace perceptor
