/// @file What the robot sees and the building's map does not have: things that stay, and things
/// that move.
///
/// Ends of beams before the map's walls are counted in cells of the world; beams that pass through
/// a cell count against it. Cells that were hit for a while and are not passed through are static;
/// cells hit just now are dynamic (the two-sided count of occupancy grids: H. Moravec and A. Elfes,
/// "High resolution maps from wide angle sonar", ICRA 1985). Cells that touch are one object.
#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "common/geometry/position.hpp"

namespace perceptor::localize {

struct UnknownObjectParameters {
  double cell = 0.1;       ///< [m]
  double hit = 1.0;        ///< what a beam that ends in a cell counts
  double pass = 0.7;       ///< what one that passes through counts against it
  double most = 30.0;      ///< a cell's count is no larger: it can be forgotten
  double least = 6.0;      ///< of a static cell
  double min_age = 2.7;    ///< [s] that a cell was hit, then it is static until it is passed
  int few = 3;             ///< a thing of no more cells may be a person about to turn back
  double few_age = 5.0;    ///< [s] that one of these cells has to be hit instead
  double pause = 0.7;      ///< [s] without a beam, and that time begins anew
  double object = 20.0;    ///< least count of a static object, over its cells
  double moving = 3.0;     ///< least count of a dynamic one
  double fresh = 0.3;      ///< [s] since a dynamic cell was hit
  double behind = 0.2;     ///< [m] so far behind a cell a beam that passes through it ends
  double touching = 0.25;  ///< [m] cells this close are of one object
  int max_cells = 4000;    ///< then the weakest go
};

/// A beam, world frame.
struct WorldBeam {
  Vector2 origin;     ///< [m]
  Vector2 direction;  ///< unit vector
  double range;       ///< [m]
};

/// A rectangle around what was seen.
struct UnknownObject {
  std::int32_t id = 0;  ///< stays with it
  bool is_static = false;
  std::vector<Vector2> outline;  ///< [m] world frame, four corners counter-clockwise
  double weight = 0.0;           ///< beams that speak for it
  std::int64_t first_seen = 0;   ///< [us]
  std::int64_t last_seen = 0;    ///< [us]
};

class UnknownObjects {
 public:
  explicit UnknownObjects(const UnknownObjectParameters& parameters) : parameters_(parameters) {}

  /// One scan: all its beams, in the order of their bearings, and which of them end on something
  /// that the map does not have.
  void add(const std::vector<WorldBeam>& beams, const std::vector<bool>& is_unknown,
           std::int64_t utime);

  std::vector<UnknownObject> objects(std::int64_t utime);

  void clear() { cells_.clear(); }

 private:
  using Key = std::pair<int, int>;
  struct Cell {
    double count = 0.0;
    Vector2 mean = Vector2::Zero();  ///< [m] of the ends in it
    int hits = 0;
    std::int64_t first_hit = 0;  ///< [us]
    std::int64_t hit_since = 0;  ///< [us] without a pause
    std::int64_t last_hit = 0;   ///< [us]
    double stayed = 0.0;         ///< [s] the longest without a pause
    std::int32_t id = 0;         ///< of the object it was part of; 0: none
  };

  Key key_of(const Vector2& place) const;
  void pass(const std::vector<WorldBeam>& beams);
  void hit(const Vector2& place, std::int64_t utime);
  void forget_weakest();

  UnknownObjectParameters parameters_;
  std::map<Key, Cell> cells_;
  std::int32_t last_id_ = 0;
};

}  // namespace perceptor::localize
