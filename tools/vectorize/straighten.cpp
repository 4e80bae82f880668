#include "tools/vectorize/straighten.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <Eigen/Eigenvalues>

#include "common/geometry/line.hpp"

namespace perceptor {
namespace {

using Places = std::vector<Vector2>;

/// Indices of the places between `first` and `last` that stay.
void find_corners(const Places& places, std::size_t first, std::size_t last, double tolerance,
                  std::vector<std::size_t>& corners) {
  const Segment chord{places[first], places[last]};
  std::size_t farthest = first;
  double most = tolerance;
  for (std::size_t i = first + 1; i < last; ++i) {
    const double off = distance(chord, places[i]);
    if (off <= most) continue;
    most = off;
    farthest = i;
  }
  if (farthest == first) return;
  find_corners(places, first, farthest, tolerance, corners);
  corners.push_back(farthest);
  find_corners(places, farthest, last, tolerance, corners);
}

/// A line of total least squares, in the direction of the places. Those at its ends may be the
/// neighbours': where there are others, they do not count.
Line fit(const Places& places, std::size_t first, std::size_t last) {
  constexpr std::size_t kEnough = 4;
  if (last - first >= kEnough) {
    ++first;
    --last;
  }
  const auto count = static_cast<double>(last - first + 1);
  Vector2 mean = Vector2::Zero();
  for (std::size_t i = first; i <= last; ++i) mean += places[i] / count;
  Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
  for (std::size_t i = first; i <= last; ++i)
    scatter += (places[i] - mean) * (places[i] - mean).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(scatter);
  Vector2 along = axes.eigenvectors().col(1);
  if (along.dot(places[last] - places[first]) < 0.0) along = -along;
  return {mean, along, perpendicular(along), (places[last] - places[first]).norm()};
}

Vector2 dropped_on(const Line& line, const Vector2& place) {
  return point_at(line, place_on(line, place));
}

/// Where two lines meet, if that is near the corner that was found.
Vector2 corner_of(const Line& p, const Line& q, const Vector2& found, double reach) {
  const double sine = cross(p.along, q.along);
  if (std::abs(sine) > 0.1) {
    const double along = cross(q.middle - p.middle, q.along) / sine;
    Vector2 meet = p.middle + along * p.along;
    if (distance(meet, found) < reach) return meet;
  }
  return (dropped_on(p, found) + dropped_on(q, found)) / 2.0;
}

}  // namespace

std::vector<Segment> straighten(const Outline& outline, double tolerance,
                                const std::function<double(const Line&)>& inset) {
  Places places = outline.places;
  if (places.size() < 2) return {};
  if (outline.is_closed) {
    // From one of its extremes, which is a corner.
    const auto lowest = std::ranges::min_element(
        places, [](const Vector2& p, const Vector2& q) { return p.x() + p.y() < q.x() + q.y(); });
    std::ranges::rotate(places, lowest);
    places.push_back(places.front());
  }
  std::vector<std::size_t> corners = {0};
  if (outline.is_closed) {
    const auto farthest = std::ranges::max_element(
        places, {}, [&](const Vector2& place) { return distance(place, places.front()); });
    const auto middle = static_cast<std::size_t>(farthest - places.begin());
    find_corners(places, 0, middle, tolerance, corners);
    corners.push_back(middle);
    find_corners(places, middle, places.size() - 1, tolerance, corners);
  } else {
    find_corners(places, 0, places.size() - 1, tolerance, corners);
  }
  corners.push_back(places.size() - 1);

  std::vector<Line> lines;
  double deepest = 0.0;
  for (std::size_t i = 1; i < corners.size(); ++i) {
    Line line = fit(places, corners[i - 1], corners[i]);
    const double depth = inset(line);
    line.middle -= depth * line.normal;
    deepest = std::max(deepest, depth);
    lines.push_back(line);
  }
  const double reach = 3.0 * tolerance + 2.0 * deepest;  // corners move farther than lines
  Places ends;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector2& found = places[corners[i]];
    const bool is_outer = i == 0 || i + 1 == corners.size();
    if (is_outer && outline.is_closed)
      ends.push_back(corner_of(lines.back(), lines.front(), found, reach));
    else if (is_outer)
      ends.push_back(dropped_on(i == 0 ? lines.front() : lines.back(), found));
    else
      ends.push_back(corner_of(lines[i - 1], lines[i], found, reach));
  }
  std::vector<Segment> pieces;
  for (std::size_t i = 1; i < ends.size(); ++i) pieces.push_back({ends[i - 1], ends[i]});
  return pieces;
}

}  // namespace perceptor
