/// @file The faces into which edges divide the plane, as a doubly connected edge list (Muller
/// and Preparata 1978; de Berg et al., "Computational Geometry", chapter 2).
///
/// Each edge is two half-edges, one each way, each with the face on its left. Half-edges 2e and
/// 2e + 1 are those of edge e: the first runs from the edge's first end to its second.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "common/global_map/noding.hpp"

namespace perceptor::global_map {

inline constexpr std::size_t kNowhere = std::numeric_limits<std::size_t>::max();

/// The face around everything.
inline constexpr std::size_t kOutside = 0;

constexpr std::size_t twin(std::size_t half_edge) { return half_edge ^ 1U; }
constexpr std::size_t edge_of(std::size_t half_edge) { return half_edge / 2; }

/// A connected part of the plane that no edge runs through.
struct Face {
  std::size_t outline = kNowhere;  ///< a half-edge of the cycle around it; none: outside
  std::size_t around = kOutside;   ///< the face that what it is a part of stands in
  double outline_area = 0.0;       ///< [m^2] within the outline
  double area = 0.0;               ///< [m^2] without what stands in it
  double perimeter = 0.0;          ///< [m] of its outline and of all that stands in it
};

class Arrangement {
 public:
  explicit Arrangement(PlanarGraph graph);

  const PlanarGraph& graph() const { return graph_; }
  const std::vector<Face>& faces() const { return faces_; }
  std::size_t half_edges() const { return 2 * graph_.edges.size(); }

  std::size_t origin(std::size_t half_edge) const;  ///< a vertex
  std::size_t target(std::size_t half_edge) const;  ///< a vertex
  Segment segment(std::size_t half_edge) const;     ///< [m] from origin to target
  const EdgeKind& kind(std::size_t half_edge) const;
  std::size_t face(std::size_t half_edge) const { return face_[half_edge]; }

  /// The half-edge that follows on the boundary of the face on the left.
  std::size_t next(std::size_t half_edge) const { return next_[half_edge]; }

  /// Of edges.
  std::size_t degree(std::size_t vertex) const { return degree_[vertex]; }

  /// The face that a place [m] lies in; of a place on an edge, either.
  std::size_t face_at(const Vector2& place) const;

  /// A place [m] in the face on the left of a half-edge, off its middle.
  Vector2 place_beside(std::size_t half_edge) const;

 private:
  struct Cycle;

  void link_half_edges();
  std::vector<Cycle> find_cycles() const;
  void find_components(std::vector<Cycle>& cycles) const;
  void make_faces(std::vector<Cycle>& cycles);
  bool encloses(const Cycle& cycle, const Vector2& place) const;
  bool is_crossed(std::size_t half_edge, const Vector2& place) const;

  PlanarGraph graph_;
  std::vector<std::size_t> next_;
  std::vector<std::size_t> face_;
  std::vector<std::size_t> degree_;
  std::vector<std::size_t> last_out_;  ///< of a vertex: the half-edge of the largest angle
  std::vector<Face> faces_;
};

}  // namespace perceptor::global_map
