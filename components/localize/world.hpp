/// @file The known building, prepared for being compared with what the robot sees.
#pragma once

#include <cstddef>
#include <vector>

#include "common/geometry/line.hpp"
#include "common/model/map.hpp"

namespace perceptor::localize {

/// One side of a wall or a cabinet, free space on its left.
struct Face {
  Segment segment;  ///< [m] world frame
  Line line;
};

/// Faces in one line that look the same way. What is seen of them may be one wall, where a door
/// between them is shut.
struct Front {
  Line line;                     ///< its middle is any place on it
  std::vector<Interval> pieces;  ///< [m] along the line, from its middle, in order: faces
  std::vector<Interval> gaps;    ///< between them, as wide as a door is: it may be shut
};

struct WorldParameters {
  double min_door = 0.4;  ///< [m] narrower gaps in a line of walls are no doors
  double max_door = 1.6;  ///< [m] nor are wider ones
};

/// What a ray meets first: distances [m] from its origin, infinite where there is nothing.
struct Met {
  double face;
  double door;  ///< an opening that may be shut, before the face
};

class World {
 public:
  /// Walls with a free side, cabinets and doors of a global map.
  explicit World(const Map& global_map, const WorldParameters& parameters = {});

  const std::vector<Face>& faces() const { return faces_; }
  const std::vector<Front>& fronts() const { return fronts_; }

  /// `direction` is a unit vector.
  Met meet(const Vector2& origin, const Vector2& direction) const;

 private:
  /// Lines for ray casting, each component in its own array: ten times as fast as one by one.
  struct Rays {
    std::vector<double> ax, ay, dx, dy;
    void add(const Segment& segment);
    double nearest(const Vector2& origin, const Vector2& direction) const;
  };

  void add_face(const Segment& segment);
  void find_gaps(Front& front, const WorldParameters& parameters);

  std::vector<Face> faces_;
  std::vector<Front> fronts_;
  Rays solid_;
  Rays doors_;
};

}  // namespace perceptor::localize
