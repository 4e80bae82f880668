#include "common/global_map/arrangement.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "common/global_map/disjoint_sets.hpp"

namespace perceptor::global_map {

/// Half-edges that follow each other around a face: counter-clockwise around what is inside it,
/// its outline, or clockwise around a component, seen from the face that it stands in.
struct Arrangement::Cycle {
  std::size_t first = 0;      ///< its smallest half-edge
  double area = 0.0;          ///< [m^2] within it, negative where it goes round clockwise
  double perimeter = 0.0;     ///< [m]
  Vector2 low;                ///< [m] of all its vertices
  Vector2 high;               ///< [m]
  std::size_t component = 0;  ///< the smallest vertex that it is connected to
  bool is_outline = true;     ///< else it goes round a component
  std::size_t face = kOutside;
};

Arrangement::Arrangement(PlanarGraph graph) : graph_(std::move(graph)) {
  link_half_edges();
  std::vector<Cycle> cycles = find_cycles();
  find_components(cycles);
  make_faces(cycles);
}

std::size_t Arrangement::origin(std::size_t half_edge) const {
  return graph_.edges[edge_of(half_edge)].ends.at(half_edge % 2);
}

std::size_t Arrangement::target(std::size_t half_edge) const { return origin(twin(half_edge)); }

Segment Arrangement::segment(std::size_t half_edge) const {
  return {graph_.vertices[origin(half_edge)], graph_.vertices[target(half_edge)]};
}

const EdgeKind& Arrangement::kind(std::size_t half_edge) const {
  return graph_.edges[edge_of(half_edge)].kind;
}

void Arrangement::link_half_edges() {
  std::vector<std::size_t> order(half_edges());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [this](std::size_t half_edge) {
    return std::pair(origin(half_edge), angle(segment(half_edge)));
  });
  next_.resize(half_edges());
  degree_.assign(graph_.vertices.size(), 0);
  last_out_.assign(graph_.vertices.size(), kNowhere);
  for (std::size_t begin = 0; begin < order.size();) {
    std::size_t end = begin;
    while (end < order.size() && origin(order[end]) == origin(order[begin])) ++end;
    degree_[origin(order[begin])] = end - begin;
    last_out_[origin(order[begin])] = order[end - 1];
    // The face on the left of one that arrives goes on clockwise from where it came.
    for (std::size_t i = begin; i < end; ++i) {
      const std::size_t clockwise = i == begin ? end - 1 : i - 1;
      next_[twin(order[i])] = order[clockwise];
    }
    begin = end;
  }
}

std::vector<Arrangement::Cycle> Arrangement::find_cycles() const {
  std::vector<Cycle> cycles;
  std::vector<bool> is_seen(half_edges(), false);
  for (std::size_t first = 0; first < half_edges(); ++first) {
    if (is_seen[first]) continue;
    Cycle cycle;
    cycle.first = first;
    const Vector2 start = segment(first).a;
    cycle.low = cycle.high = start;
    for (std::size_t h = first; !is_seen[h]; h = next(h)) {
      is_seen[h] = true;
      const Segment side = segment(h);
      cycle.area += 0.5 * cross(side.a - start, side.b - start);
      cycle.perimeter += length(side);
      cycle.low = cycle.low.cwiseMin(side.a);
      cycle.high = cycle.high.cwiseMax(side.a);
    }
    cycles.push_back(cycle);
  }
  return cycles;
}

void Arrangement::find_components(std::vector<Cycle>& cycles) const {
  DisjointSets components(graph_.vertices.size());
  for (const Edge& edge : graph_.edges) components.join(edge.ends[0], edge.ends[1]);

  // Seen from a component's first vertex from the left (of several, the lowest), all its edges
  // lead to the right: on the left of the steepest one lies what is around the component.
  std::vector<std::size_t> leftmost(graph_.vertices.size(), kNowhere);
  for (std::size_t vertex = 0; vertex < graph_.vertices.size(); ++vertex) {
    if (degree(vertex) == 0) continue;
    std::size_t& first = leftmost[components.find(vertex)];
    const Vector2& place = graph_.vertices[vertex];
    const auto is_before = [&](const Vector2& other) {
      return std::pair(place.x(), place.y()) < std::pair(other.x(), other.y());
    };
    if (first == kNowhere || is_before(graph_.vertices[first])) first = vertex;
  }
  std::vector<bool> is_steepest(half_edges(), false);
  for (const std::size_t vertex : leftmost)
    if (vertex != kNowhere) is_steepest[last_out_[vertex]] = true;

  for (Cycle& cycle : cycles) {
    cycle.component = components.find(origin(cycle.first));
    std::size_t h = cycle.first;
    do {
      if (is_steepest[h]) cycle.is_outline = false;
      h = next(h);
    } while (h != cycle.first);
  }
}

void Arrangement::make_faces(std::vector<Cycle>& cycles) {
  faces_.assign(1, Face{});
  std::vector<const Cycle*> outlines;
  for (Cycle& cycle : cycles) {
    if (!cycle.is_outline) continue;
    cycle.face = faces_.size();
    faces_.push_back({cycle.first, kOutside, cycle.area, cycle.area, cycle.perimeter});
    outlines.push_back(&cycle);
  }
  std::ranges::stable_sort(outlines, {}, [](const Cycle* cycle) { return cycle->area; });

  // What a component stands in: the smallest outline of another component around it.
  std::vector<std::size_t> around(graph_.vertices.size(), kOutside);
  for (Cycle& cycle : cycles) {
    if (cycle.is_outline) continue;
    const auto is_around = [&](const Cycle* outline) {
      return outline->component != cycle.component && encloses(*outline, segment(cycle.first).a);
    };
    const auto found = std::ranges::find_if(outlines, is_around);
    cycle.face = found == outlines.end() ? kOutside : (*found)->face;
    around[cycle.component] = cycle.face;
    Face& face = faces_[cycle.face];
    face.area -= std::abs(cycle.area);
    face.perimeter += cycle.perimeter;
  }
  for (const Cycle& cycle : cycles)
    if (cycle.is_outline) faces_[cycle.face].around = around[cycle.component];

  face_.resize(half_edges());
  for (const Cycle& cycle : cycles) {
    std::size_t h = cycle.first;
    do {
      face_[h] = cycle.face;
      h = next(h);
    } while (h != cycle.first);
  }
}

/// By a ray towards +x. A side owns its lower end only, so that a ray through a corner is
/// counted once; an edge that sticks into the face is there twice, and cancels out.
bool Arrangement::is_crossed(std::size_t half_edge, const Vector2& place) const {
  const auto [a, b] = segment(half_edge);
  if ((a.y() > place.y()) == (b.y() > place.y())) return false;
  const double fraction = (place.y() - a.y()) / (b.y() - a.y());
  return place.x() < a.x() + fraction * (b.x() - a.x());
}

bool Arrangement::encloses(const Cycle& cycle, const Vector2& place) const {
  const bool is_beside =
      (place.array() < cycle.low.array()).any() || (place.array() > cycle.high.array()).any();
  if (is_beside) return false;
  bool inside = false;
  std::size_t h = cycle.first;
  do {
    if (is_crossed(h, place)) inside = !inside;
    h = next(h);
  } while (h != cycle.first);
  return inside;
}

std::size_t Arrangement::face_at(const Vector2& place) const {
  std::vector<bool> is_inside(faces_.size(), false);
  for (std::size_t h = 0; h < half_edges(); ++h)
    if (is_crossed(h, place)) is_inside[face(h)] = !is_inside[face(h)];
  // A face is the only one whose whole boundary, holes included, is crossed an odd number of
  // times; the one outside counts the other way round.
  for (std::size_t i = kOutside + 1; i < faces_.size(); ++i)
    if (is_inside[i]) return i;
  return kOutside;
}

Vector2 Arrangement::place_beside(std::size_t half_edge) const {
  const Segment side = segment(half_edge);
  const Vector2 start = middle(side);
  const Vector2 ahead = perpendicular(direction(side));
  // Half of the way to what a ray from the middle meets first.
  double nearest = length(side);
  for (std::size_t other = 0; other < half_edges(); other += 2) {
    if (edge_of(other) == edge_of(half_edge)) continue;
    const auto [a, b] = segment(other);
    const double a_side = cross(ahead, a - start);
    const double b_side = cross(ahead, b - start);
    if ((a_side > 0.0) == (b_side > 0.0)) continue;
    const double along = ahead.dot(a + a_side / (a_side - b_side) * (b - a) - start);
    if (along > 0.0) nearest = std::min(nearest, along);
  }
  return start + 0.5 * nearest * ahead;
}

}  // namespace perceptor::global_map
