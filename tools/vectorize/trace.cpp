#include "tools/vectorize/trace.hpp"

#include <array>
#include <cstddef>
#include <set>
#include <utility>

namespace perceptor {
namespace {

using Vertex = std::pair<int, int>;  // x, y: a corner of cells

/// Which way a side runs; what is not occupied lies to its left.
enum Heading : std::size_t { east, north, west, south };
constexpr std::array<Vertex, 4> kStep = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

Vertex moved(const Vertex& from, Heading heading) {
  return {from.first + kStep[heading].first, from.second + kStep[heading].second};
}

Heading turned_left(Heading heading) { return static_cast<Heading>((heading + 1) % 4); }

/// The cell to the left of a side that runs from a vertex.
Vertex cell_left_of(const Vertex& from, Heading heading) {
  switch (heading) {
    case east:
      return from;
    case north:
      return {from.first - 1, from.second};
    case west:
      return {from.first - 1, from.second - 1};
    case south:
      return {from.first, from.second - 1};
  }
  return from;
}

struct Side {
  Vertex from;
  Heading heading;
  friend auto operator<=>(const Side&, const Side&) = default;
};

class Tracer {
 public:
  Tracer(const OccupancyGrid& grid, int reach) : grid_(grid), reach_(reach) {}

  std::vector<Outline> trace() {
    for (int y = 0; y < grid_.height; ++y)
      for (int x = 0; x < grid_.width; ++x)
        if (grid_.at(x, y) == CellState::occupied) add_sides(x, y);
    while (!left_.empty()) cut(follow(*left_.begin()));
    return std::move(outlines_);
  }

 private:
  bool is_occupied(const Vertex& cell) const {
    return grid_.at(cell.first, cell.second) == CellState::occupied;
  }

  void add_sides(int x, int y) {
    if (!is_occupied({x, y + 1})) left_.insert({{x, y + 1}, east});
    if (!is_occupied({x - 1, y})) left_.insert({{x, y}, north});
    if (!is_occupied({x, y - 1})) left_.insert({{x + 1, y}, west});
    if (!is_occupied({x + 1, y})) left_.insert({{x + 1, y + 1}, south});
  }

  /// Once around something occupied.
  std::vector<Side> follow(Side side) {
    std::vector<Side> loop;
    while (left_.erase(side) > 0) {
      loop.push_back(side);
      const Vertex at = moved(side.from, side.heading);
      // Leftmost first: onto the cell that touches at the corner.
      for (const int turns : {1, 0, 3}) {
        Heading heading = side.heading;
        for (int i = 0; i < turns; ++i) heading = turned_left(heading);
        if (left_.contains({at, heading}) ||
            (heading == loop.front().heading && at == loop.front().from)) {
          side = {at, heading};
          break;
        }
      }
    }
    return loop;
  }

  bool faces_free_space(const Side& side) const {
    const Heading away = turned_left(side.heading);
    Vertex cell = cell_left_of(side.from, side.heading);
    for (int i = 0; i <= reach_; ++i, cell = moved(cell, away)) {
      if (is_occupied(cell)) return false;
      if (grid_.at(cell.first, cell.second) == CellState::free) return true;
    }
    return false;
  }

  /// The stretches of a loop that face free space; a cell's side between two of them does too.
  void cut(const std::vector<Side>& loop) {
    constexpr std::size_t kBridged = 2;
    const std::size_t n = loop.size();
    std::vector<bool> faces;
    faces.reserve(n);
    for (const Side& side : loop) faces.push_back(faces_free_space(side));
    std::size_t start = 0;
    while (start < n && faces[start]) ++start;
    if (start == n) return keep(loop, 0, n, true);
    std::size_t i = 0;
    while (i < n) {
      if (!faces[(start + i) % n]) {
        ++i;
        continue;
      }
      std::size_t end = i;
      for (std::size_t k = i; k < n && k - end <= kBridged; ++k)
        if (faces[(start + k) % n]) end = k;
      keep(loop, start + i, end - i + 1, false);
      i = end + 1;
    }
  }

  void keep(const std::vector<Side>& loop, std::size_t begin, std::size_t count, bool is_closed) {
    Outline outline;
    outline.is_closed = is_closed;
    for (std::size_t i = 0; i < count; ++i) {
      const Side& side = loop[(begin + i) % loop.size()];
      const Vertex to = moved(side.from, side.heading);
      const Vector2 middle((side.from.first + to.first) / 2.0,
                           (side.from.second + to.second) / 2.0);
      outline.places.push_back(transform(grid_.grid_in_world, grid_.resolution * middle));
    }
    outlines_.push_back(std::move(outline));
  }

  const OccupancyGrid& grid_;
  int reach_;
  std::set<Side> left_;  ///< sides that no outline has yet
  std::vector<Outline> outlines_;
};

}  // namespace

std::vector<Outline> trace_outlines(const OccupancyGrid& grid, int reach) {
  return Tracer(grid, reach).trace();
}

}  // namespace perceptor
