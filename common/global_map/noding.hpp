/// @file Lines as people draw them become edges that meet only in their ends: lines that cross
/// or touch are cut there, points that nearly coincide become one, and what was drawn twice is
/// one edge. What computational geometry calls noding (with snapping, as in Hobby, "Practical
/// segment intersection with finite precision output", 1999).
#pragma once

#include <array>
#include <cstddef>
#include <stdexcept>
#include <vector>

#include "common/geometry/segment.hpp"

namespace perceptor::global_map {

inline constexpr int kNoCabinet = -1;

/// What an edge is. Drawn twice, it may be several things.
struct EdgeKind {
  bool is_wall = false;
  int cabinet = kNoCabinet;  ///< whose side it is; where two share it, the first
  bool is_door = false;
  bool is_closing = false;  ///< of a gap to the outside; nobody drew it

  /// A laser ends on it.
  bool is_solid() const { return is_wall || cabinet != kNoCabinet; }

  /// It parts faces, and joins them.
  bool is_opening() const { return is_door || is_closing; }

  friend bool operator==(const EdgeKind&, const EdgeKind&) = default;
};

struct DrawnLine {
  Segment segment;  ///< [m]
  EdgeKind kind;
};

struct Edge {
  std::array<std::size_t, 2> ends{};  ///< indices into PlanarGraph::vertices, the smaller first
  EdgeKind kind;
};

/// No two edges cross, none runs through a vertex, and none is there twice.
struct PlanarGraph {
  std::vector<Vector2> vertices;  ///< [m]
  std::vector<Edge> edges;
};

/// The lines cross each other so often that they are no building.
class TooManyCrossings : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The graph of the lines; the same whatever their order and direction. Points nearer to each
/// other, or to a line, than `snap` [m] coincide. Lines shorter than that vanish. Throws
/// TooManyCrossings.
PlanarGraph node(const std::vector<DrawnLine>& lines, double snap);

}  // namespace perceptor::global_map
