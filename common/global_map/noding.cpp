#include "common/global_map/noding.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace perceptor::global_map {
namespace {

/// More than any building has; each takes memory.
constexpr std::size_t kMostCuts = 400'000;

bool is_before(const Vector2& p, const Vector2& q) {
  return std::pair(p.x(), p.y()) < std::pair(q.x(), q.y());
}

/// Gives nearby places one vertex: the first that came.
class Vertices {
 public:
  explicit Vertices(double snap) : snap_(snap) {}

  std::size_t at(const Vector2& place) {
    const Cell cell = cell_of(place);
    for (std::int64_t dx = -1; dx <= 1; ++dx)
      for (std::int64_t dy = -1; dy <= 1; ++dy) {
        const auto [begin, end] = by_cell_.equal_range(key_of({cell.x + dx, cell.y + dy}));
        for (auto it = begin; it != end; ++it)
          if (distance(places_[it->second], place) <= snap_) return it->second;
      }
    by_cell_.emplace(key_of(cell), places_.size());
    places_.push_back(place);
    return places_.size() - 1;
  }

  const Vector2& operator[](std::size_t vertex) const { return places_[vertex]; }
  std::vector<Vector2> take() { return std::move(places_); }

 private:
  struct Cell {
    std::int64_t x = 0;
    std::int64_t y = 0;
  };

  Cell cell_of(const Vector2& place) const {
    return {static_cast<std::int64_t>(std::floor(place.x() / snap_)),
            static_cast<std::int64_t>(std::floor(place.y() / snap_))};
  }
  /// Cells with one key are told apart by distance.
  static std::uint64_t key_of(const Cell& cell) {
    return static_cast<std::uint64_t>(cell.x) * 0x9E3779B97F4A7C15ULL +
           static_cast<std::uint64_t>(cell.y);
  }

  double snap_;
  std::vector<Vector2> places_;
  std::unordered_multimap<std::uint64_t, std::size_t> by_cell_;
};

/// A line between two vertices, and where it is cut.
struct Piece {
  std::size_t from = 0;
  std::size_t to = 0;
  EdgeKind kind;
  Segment segment;
  Vector2 low;
  Vector2 high;
  std::vector<std::size_t> cuts;  ///< vertices on it, in no order, perhaps repeated
};

/// From the lower end to the higher, in an order that depends on the lines alone.
std::vector<DrawnLine> in_order(std::vector<DrawnLine> lines) {
  for (DrawnLine& line : lines)
    if (is_before(line.segment.b, line.segment.a)) std::swap(line.segment.a, line.segment.b);
  const auto key = [](const DrawnLine& line) {
    const auto& [a, b] = line.segment;
    return std::tuple(a.x(), a.y(), b.x(), b.y(), line.kind.is_wall, line.kind.cabinet,
                      line.kind.is_door, line.kind.is_closing);
  };
  std::ranges::sort(lines, {}, key);
  return lines;
}

std::vector<Piece> pieces_of(const std::vector<DrawnLine>& lines, double snap, Vertices& vertices) {
  std::vector<Vector2> ends;
  for (const DrawnLine& line : lines) {
    ends.push_back(line.segment.a);
    ends.push_back(line.segment.b);
  }
  std::ranges::sort(ends, is_before);
  for (const Vector2& end : ends) vertices.at(end);

  std::vector<Piece> pieces;
  for (const auto& [drawn, kind] : lines) {
    const std::size_t from = vertices.at(drawn.a);
    const std::size_t to = vertices.at(drawn.b);
    if (from == to) continue;
    const Segment segment{vertices[from], vertices[to]};
    const Vector2 margin(snap, snap);
    pieces.push_back({from,
                      to,
                      kind,
                      segment,
                      segment.a.cwiseMin(segment.b) - margin,
                      segment.a.cwiseMax(segment.b) + margin,
                      {}});
  }
  std::ranges::stable_sort(pieces, {}, [](const Piece& piece) { return piece.low.x(); });
  return pieces;
}

void cut_at_ends_of(Piece& piece, const Piece& other, double snap) {
  for (const auto& [vertex, place] :
       {std::pair(other.from, other.segment.a), std::pair(other.to, other.segment.b)}) {
    if (vertex == piece.from || vertex == piece.to) continue;
    if (distance(piece.segment, place) <= snap) piece.cuts.push_back(vertex);
  }
}

/// Where two pieces cross, none of their ends being near the other.
std::optional<Vector2> crossing(const Segment& s, const Segment& t, double snap) {
  const double a_side = signed_distance(s, t.a);
  const double b_side = signed_distance(s, t.b);
  const bool parts_t = std::min(a_side, b_side) < -snap && std::max(a_side, b_side) > snap;
  const double c_side = signed_distance(t, s.a);
  const double d_side = signed_distance(t, s.b);
  const bool parts_s = std::min(c_side, d_side) < -snap && std::max(c_side, d_side) > snap;
  if (!parts_t || !parts_s) return std::nullopt;
  return Vector2(t.a + a_side / (a_side - b_side) * (t.b - t.a));
}

void cut_each_other(Piece& p, Piece& q, double snap, Vertices& vertices) {
  cut_at_ends_of(p, q, snap);
  cut_at_ends_of(q, p, snap);
  if (const auto place = crossing(p.segment, q.segment, snap)) {
    const std::size_t vertex = vertices.at(*place);
    p.cuts.push_back(vertex);
    q.cuts.push_back(vertex);
  }
}

void cut_all(std::vector<Piece>& pieces, double snap, Vertices& vertices) {
  std::size_t cuts = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    Piece& p = pieces[i];
    for (std::size_t j = i + 1; j < pieces.size() && pieces[j].low.x() <= p.high.x(); ++j) {
      Piece& q = pieces[j];
      const bool is_apart = q.low.y() > p.high.y() || q.high.y() < p.low.y();
      if (is_apart) continue;
      const std::size_t before = p.cuts.size() + q.cuts.size();
      cut_each_other(p, q, snap, vertices);
      cuts += p.cuts.size() + q.cuts.size() - before;
      if (cuts > kMostCuts)
        throw TooManyCrossings("lines touch or cross each other more than " +
                               std::to_string(kMostCuts / 2) + " times: no building");
    }
  }
}

void add_kind(EdgeKind& kind, const EdgeKind& other) {
  kind.is_wall |= other.is_wall;
  kind.is_door |= other.is_door;
  kind.is_closing |= other.is_closing;
  if (kind.cabinet == kNoCabinet)
    kind.cabinet = other.cabinet;
  else if (other.cabinet != kNoCabinet)
    kind.cabinet = std::min(kind.cabinet, other.cabinet);
}

using EdgeKinds = std::map<std::array<std::size_t, 2>, EdgeKind>;

void add_edges(Piece& piece, const Vertices& vertices, EdgeKinds& kinds) {
  piece.cuts.push_back(piece.from);
  piece.cuts.push_back(piece.to);
  const Vector2 along = direction(piece.segment);
  std::ranges::sort(piece.cuts, {}, [&](std::size_t vertex) {
    return std::pair(along.dot(vertices[vertex] - piece.segment.a), vertex);
  });
  for (std::size_t i = 0; i + 1 < piece.cuts.size(); ++i) {
    const auto [low, high] = std::minmax(piece.cuts[i], piece.cuts[i + 1]);
    if (low != high) add_kind(kinds[{low, high}], piece.kind);
  }
}

}  // namespace

PlanarGraph node(const std::vector<DrawnLine>& lines, double snap) {
  Vertices vertices(snap);
  std::vector<Piece> pieces = pieces_of(in_order(lines), snap, vertices);
  cut_all(pieces, snap, vertices);
  EdgeKinds kinds;
  for (Piece& piece : pieces) add_edges(piece, vertices, kinds);

  PlanarGraph graph;
  for (const auto& [ends, kind] : kinds) graph.edges.push_back({ends, kind});
  graph.vertices = vertices.take();
  return graph;
}

}  // namespace perceptor::global_map
