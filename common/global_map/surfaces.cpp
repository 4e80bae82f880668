#include "common/global_map/surfaces.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>

#include "common/geometry/line.hpp"

namespace perceptor::global_map {
namespace {

double turn_between(const Segment& s, const Segment& t) {
  return perceptor::turn_between(line_of(s), line_of(t));
}

/// Half-edges that a laser sees, each followed by the next on the same boundary.
class Boundary {
 public:
  explicit Boundary(const FreeSpace& space)
      : space_(space), arrangement_(space.arrangement), previous_(size(), kNowhere) {
    for (std::size_t h = 0; h < size(); ++h)
      if (is_seen(h) && next(h) != kNowhere) previous_[next(h)] = h;
  }

  std::size_t size() const { return arrangement_.half_edges(); }

  bool is_seen(std::size_t half_edge) const {
    return arrangement_.kind(half_edge).is_solid() && space_.is_free_beside(half_edge);
  }

  /// Past openings, which a laser does not see; none where the boundary goes on to a place that
  /// is not free.
  std::size_t next(std::size_t half_edge) const {
    std::size_t h = arrangement_.next(half_edge);
    while (!arrangement_.kind(h).is_solid()) h = arrangement_.next(twin(h));
    return is_seen(h) ? h : kNowhere;
  }
  std::size_t previous(std::size_t half_edge) const { return previous_[half_edge]; }

  Segment segment(std::size_t half_edge) const { return arrangement_.segment(half_edge); }

  /// Where a wall and a cabinet share a side, it is the wall's.
  int cabinet_of(std::size_t half_edge) const {
    const EdgeKind& kind = arrangement_.kind(half_edge);
    return kind.is_wall ? kNoCabinet : kind.cabinet;
  }

  /// Whether a surface may go on over the vertex at its end.
  bool goes_straight_on(std::size_t from, std::size_t to, double angle) const {
    return cabinet_of(from) == cabinet_of(to) &&
           std::abs(turn_between(segment(from), segment(to))) <= angle;
  }

 private:
  const FreeSpace& space_;
  const Arrangement& arrangement_;
  std::vector<std::size_t> previous_;
};

/// Where a walk along a boundary may begin: a corner, or an end.
bool is_corner(const Boundary& boundary, std::size_t half_edge, double straight_angle) {
  const std::size_t previous = boundary.previous(half_edge);
  return previous == kNowhere || !boundary.goes_straight_on(previous, half_edge, straight_angle);
}

/// All half-edges of a laser's sight, the best places to begin a walk first.
std::vector<std::size_t> starts(const Boundary& boundary, double straight_angle) {
  std::vector<std::size_t> order;
  for (std::size_t h = 0; h < boundary.size(); ++h)
    if (boundary.is_seen(h)) order.push_back(h);
  std::ranges::sort(order, {}, [&](std::size_t h) {
    const Segment s = boundary.segment(h);
    const bool is_end = boundary.previous(h) == kNowhere;
    return std::tuple(!is_end, !is_corner(boundary, h, straight_angle), s.a.x(), s.a.y(), s.b.x(),
                      s.b.y());
  });
  return order;
}

class Walk {
 public:
  Walk(const Boundary& boundary, const SurfaceParameters& parameters)
      : boundary_(boundary), parameters_(parameters), is_done_(boundary.size(), false) {}

  /// Adds the surfaces of the boundary from here on, up to its end or to where they are there.
  void follow(std::size_t start, std::vector<Surface>& surfaces) {
    const std::size_t first = surfaces.size();
    std::size_t h = start;
    while (h != kNowhere && !is_done_[h]) {
      const bool follows = surfaces.size() > first;
      const std::size_t here = surfaces.size();
      const std::size_t next = add_surface(h, surfaces);
      if (follows) join(surfaces, here - 1, here);
      h = next;
    }
    const bool is_loop = h == start && surfaces.size() > first;
    if (is_loop) join(surfaces, surfaces.size() - 1, first);
  }

 private:
  static void join(std::vector<Surface>& surfaces, std::size_t surface, std::size_t next) {
    surfaces[surface].next = next;
    surfaces[next].previous = surface;
  }

  /// Gives the half-edge after it.
  std::size_t add_surface(std::size_t h, std::vector<Surface>& surfaces) {
    Segment whole = boundary_.segment(h);
    std::vector<Vector2> between;
    is_done_[h] = true;
    std::size_t next = boundary_.next(h);
    while (next != kNowhere && !is_done_[next] && goes_on(h, next, whole, between)) {
      between.push_back(whole.b);
      whole.b = boundary_.segment(next).b;
      is_done_[next] = true;
      h = next;
      next = boundary_.next(h);
    }
    surfaces.push_back({whole, boundary_.cabinet_of(h)});
    return next;
  }

  bool goes_on(std::size_t h, std::size_t next, const Segment& whole,
               const std::vector<Vector2>& between) const {
    if (!boundary_.goes_straight_on(h, next, parameters_.straight_angle)) return false;
    const Segment longer{whole.a, boundary_.segment(next).b};
    const auto is_near = [&](const Vector2& p) { return distance(longer, p) <= parameters_.snap; };
    return is_near(whole.b) && std::ranges::all_of(between, is_near);
  }

  const Boundary& boundary_;
  const SurfaceParameters& parameters_;
  std::vector<bool> is_done_;
};

/// [m]
double hidden_length(const FreeSpace& space) {
  double sum = 0.0;
  for (std::size_t h = 0; h < space.arrangement.half_edges(); h += 2) {
    const bool is_seen = space.is_free_beside(h) || space.is_free_beside(twin(h));
    if (space.arrangement.kind(h).is_wall && !is_seen) sum += length(space.arrangement.segment(h));
  }
  return sum;
}

}  // namespace

double turn_between(const Surface& surface, const Surface& next) {
  const double turn = turn_between(surface.segment, next.segment);
  constexpr double kRounding = 1e-9;  // [rad]
  return turn > std::numbers::pi - kRounding ? -std::numbers::pi : turn;
}

Surfaces find_surfaces(const FreeSpace& space, const SurfaceParameters& parameters) {
  const Boundary boundary(space);
  Surfaces found;
  Walk walk(boundary, parameters);
  for (const std::size_t start : starts(boundary, parameters.straight_angle))
    walk.follow(start, found.surfaces);
  found.hidden_length = hidden_length(space);
  return found;
}

}  // namespace perceptor::global_map
