#include "tools/eval/true_association.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/Cholesky>

namespace perceptor {
namespace {

constexpr int kIterations = 3;  // one brings all but nanometres

/// A beam that returned.
struct Return {
  Vector2 along;       ///< unit vector
  double range = 0.0;  ///< [m]
};

/// Where a beam along this unit vector meets the line of the segment [m].
double range_of(const Segment& wall, const Vector2& along) {
  return cross(wall.a, wall.b - wall.a) / cross(along, wall.b - wall.a);
}

/// Of the piece's beams those that tell of it: outliers do not.
std::vector<Return> returns_of(const LaserScan& scan, const TruePiece& piece,
                               const TrueAssociationParameters& parameters) {
  std::vector<Return> returns;
  for (std::size_t i = piece.first_beam; i <= piece.last_beam; ++i) {
    const double range = scan.ranges[i];
    const Vector2 along(std::cos(scan.bearings[i]), std::sin(scan.bearings[i]));
    const double error = range - range_of(piece.segment, along);
    if (is_return(scan, range) && std::abs(error) <= parameters.outlier_sigmas * scan.range_sigma)
      returns.push_back({along, range});
  }
  return returns;
}

/// Normal equations of a least-squares problem in two unknowns.
struct Normal {
  Eigen::Matrix2d matrix = Eigen::Matrix2d::Zero();
  Vector2 right = Vector2::Zero();

  void add(const Vector2& row, double value) {
    matrix += row * row.transpose();
    right += row * value;
  }
  Vector2 solution() const { return matrix.ldlt().solve(right); }
};

/// The line of the points p with n . p = 1 [1/m]. A beam along u meets it at the range
/// 1 / (n . u). Where the range is measured as r, r (n . r u - 1) is nearly the error of the
/// range: least squares of it are linear in n, and begin the least squares of the error itself.
std::optional<Vector2> fit_line(const std::vector<Return>& returns) {
  if (returns.size() < 2) return {};
  Normal start;
  for (const auto& [along, range] : returns) start.add(range * range * along, range);
  Vector2 n = start.solution();
  for (int i = 0; i < kIterations; ++i) {
    Normal step;
    for (const auto& [along, range] : returns) {
      const double expected = 1.0 / n.dot(along);
      step.add(expected * expected * along, expected - range);
    }
    n += step.solution();
  }
  const bool is_line = n.allFinite() && n.squaredNorm() > 0.0;
  return is_line ? std::optional(n) : std::nullopt;
}

std::optional<Segment> fit_wall(const LaserScan& scan, const TruePiece& piece,
                                const TrueAssociationParameters& parameters) {
  const auto n = fit_line(returns_of(scan, piece, parameters));
  if (!n) return {};
  const auto foot = [&](const Vector2& point) -> Vector2 {
    return point - (n->dot(point) - 1.0) / n->squaredNorm() * *n;
  };
  return Segment{foot(piece.segment.a), foot(piece.segment.b)};
}

std::optional<FoundCorner> corner_between(const Segment& before, const Segment& after,
                                          const TrueAssociationParameters& parameters) {
  if (smallest_relative_angle(before, after) <= parameters.min_turn) return {};
  const Vector2 along = direction(before);
  const double turn = cross(along, direction(after));
  const double to_corner = cross(after.a - before.a, direction(after)) / turn;
  const Vector2 corner = before.a + to_corner * along;
  const bool is_reached = distance(before.b, corner) <= parameters.max_reach &&
                          distance(after.a, corner) <= parameters.max_reach;
  if (!is_reached) return {};
  // Counter-clockwise around the laser, the corner of a room turns left.
  return FoundCorner{corner, turn < 0.0};
}

}  // namespace

FoundWalls walls_by_truth(const LabelledScan& scan, const TrueAssociationParameters& parameters) {
  std::vector<TruePiece> pieces = scan.pieces;
  std::ranges::stable_sort(pieces, {}, &TruePiece::first_beam);
  FoundWalls found;
  for (const TruePiece& piece : pieces) {
    if (!piece.has_to_be_found) continue;
    if (const auto wall = fit_wall(scan.scan, piece, parameters)) found.walls.push_back(*wall);
  }
  for (std::size_t i = 0; i + 1 < found.walls.size(); ++i)
    if (const auto corner = corner_between(found.walls[i], found.walls[i + 1], parameters))
      found.corners.push_back(*corner);
  return found;
}

}  // namespace perceptor
