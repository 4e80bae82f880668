/// @file The known building, prepared for being compared with what the robot sees.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

#include "common/geometry/line.hpp"
#include "common/model/map.hpp"
#include "components/localize/rays.hpp"

namespace perceptor::localize {

/// One side of a wall or a cabinet, free space on its left.
struct Face {
  Segment segment;  ///< [m] world frame
  Line line;
  std::size_t object = 0;  ///< of the global map: an index
};

/// Faces in one line that look the same way. What is seen of them may be one wall, where a door
/// between them is shut.
struct Front {
  Line line;                     ///< its middle is any place on it
  std::vector<Interval> pieces;  ///< [m] along the line, from its middle, in order: faces
  std::vector<Interval> walls;   ///< those of them that are walls: no door hangs on a cabinet
  std::vector<Interval> gaps;    ///< between them, as wide as a door is: it may be shut
  double length = 0.0;           ///< [m] of all these together
};

/// Where a door may be, open or shut: drawn, or a gap in a line of walls where none is drawn at
/// all.
struct Doorway {
  Segment opening;          ///< [m] world frame, in the middle of the wall
  double half_depth = 0.0;  ///< [m] to either face of the wall
};

struct WorldParameters {
  double min_door = 0.4;  ///< [m] narrower gaps in a line of walls are no doors
  double max_door = 1.6;  ///< [m] nor are wider ones
  double max_wall = 0.5;  ///< [m] openings in two faces farther apart are not in one wall
  double behind = 0.8;    ///< [m] of nothing behind a gap, or it is a niche
  double jamb = 0.5;      ///< cosine between a gap and a wall from its end; more: a corner cut off
};

/// What a ray meets: distances [m] from its origin, infinite where there is nothing.
struct Met {
  double face;  ///< the first
  double door;  ///< of the openings before it, which may be shut: the one nearest to the range
};

class World {
 public:
  /// Walls with a free side, cabinets and doors of a global map.
  explicit World(const Map& global_map, const WorldParameters& parameters = {});

  const std::vector<Face>& faces() const { return faces_; }
  const std::vector<Front>& fronts() const { return fronts_; }

  /// Calls `take(front)` for each front whose direction is within `tolerance` of `angle` [rad].
  template <class Take>
  void for_fronts_along(double angle, double tolerance, const Take& take) const {
    for (const double turn : {-2.0 * std::numbers::pi, 0.0, 2.0 * std::numbers::pi}) {
      const std::pair least{angle + turn - tolerance, std::size_t{0}};
      for (auto i = std::ranges::lower_bound(by_angle_, least);
           i != by_angle_.end() && i->first <= angle + turn + tolerance; ++i)
        take(fronts_[i->second]);
    }
  }

  /// Drawn ones come first, in order.
  const std::vector<Doorway>& doorways() const { return doorways_; }

  /// Of a beam with `range` [m]. `direction` is a unit vector. A beam may pass several openings:
  /// a door stands in either face of its wall, or between them.
  Met meet(const Vector2& origin, const Vector2& direction, double range) const;

  /// Which of faces() a ray meets first.
  RayHit meet_face(const Vector2& origin, const Vector2& direction) const {
    return rays_.first(origin, direction);
  }

  /// The face nearest to `place`, within `reach` [m], of those that are seen from `direction` (a
  /// unit vector to where the eye is) with at least `min_cosine` to their normals; null: none.
  const Face* nearest_face(const Vector2& place, const Vector2& direction, double reach,
                           double min_cosine) const;

 private:
  void add_face(const Segment& segment, std::size_t object, bool is_wall);
  void find_gaps(Front& front, const WorldParameters& parameters);
  void find_doorways(const std::vector<Segment>& drawn, const WorldParameters& parameters);
  bool is_doorway(const Front& front, const Interval& gap, const WorldParameters& parameters) const;
  bool runs_into(const Vector2& end, const Vector2& gap, const WorldParameters& parameters) const;
  bool join_doorway(const Segment& opening, const WorldParameters& parameters);

  std::vector<Face> faces_;
  std::vector<Front> fronts_;
  std::vector<Doorway> doorways_;
  std::vector<std::pair<double, std::size_t>> by_angle_;  ///< of fronts_, in order
  Rays rays_;                                             ///< at the faces; doors are openings
};

}  // namespace perceptor::localize
