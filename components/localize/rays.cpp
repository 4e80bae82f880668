#include "components/localize/rays.hpp"

#include <algorithm>
#include <cmath>

namespace perceptor::localize {
namespace {

constexpr double kLeastCell = 0.5;       // [m]
constexpr double kMostCells = 40'000.0;  // of a building however large
constexpr double kMargin = 1e-6;         // [m] lines on the edge of a cell are in both

/// Whether a line has a point in a square: it does not lie on one side of any of the four edges,
/// nor the square on one side of it.
bool reaches(const Segment& line, const Vector2& low, const Vector2& high) {
  if (std::max(line.a.x(), line.b.x()) < low.x() || std::min(line.a.x(), line.b.x()) > high.x() ||
      std::max(line.a.y(), line.b.y()) < low.y() || std::min(line.a.y(), line.b.y()) > high.y())
    return false;
  const Vector2 normal = perpendicular(line.b - line.a);
  const Vector2 middle = (low + high) / 2.0 - line.a;
  const Vector2 half = (high - low) / 2.0;
  return std::abs(normal.dot(middle)) <=
         std::abs(normal.x()) * half.x() + std::abs(normal.y()) * half.y();
}

}  // namespace

void Rays::add(const Segment& segment) {
  const Vector2 along = segment.b - segment.a;
  lines_.push_back({segment.a.x(), segment.a.y(), along.x(), along.y(), lines_.size()});
}

std::size_t Rays::cell_at(int column, int row) const {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
         static_cast<std::size_t>(column);
}

void Rays::sort() {
  if (lines_.empty()) return;
  corner_ = Vector2(lines_.front().ax, lines_.front().ay);
  Vector2 far = corner_;
  for (const Item& line : lines_)
    for (const Vector2& end :
         {Vector2(line.ax, line.ay), Vector2(line.ax + line.dx, line.ay + line.dy)}) {
      corner_ = corner_.cwiseMin(end);
      far = far.cwiseMax(end);
    }
  corner_ -= Vector2(kMargin, kMargin);
  const Vector2 size = far - corner_ + Vector2(kMargin, kMargin);
  cell_ = std::max(kLeastCell, std::sqrt(size.x() * size.y() / kMostCells));
  cell_ = std::max(cell_, std::max(size.x(), size.y()) / kMostCells);
  columns_ = static_cast<int>(size.x() / cell_) + 1;
  rows_ = static_cast<int>(size.y() / cell_) + 1;
  begins_.clear();
  in_cells_.clear();
  for (int row = 0; row < rows_; ++row)
    for (int column = 0; column < columns_; ++column) {
      begins_.push_back(in_cells_.size());
      const Vector2 low = corner_ + cell_ * Vector2(column, row) - Vector2(kMargin, kMargin);
      const Vector2 high = low + Vector2(cell_ + 2.0 * kMargin, cell_ + 2.0 * kMargin);
      for (const Item& line : lines_)
        if (reaches({{line.ax, line.ay}, {line.ax + line.dx, line.ay + line.dy}}, low, high))
          in_cells_.push_back(line);
    }
  begins_.push_back(in_cells_.size());
}

double Rays::distance_to(const Item& item, const Vector2& origin, const Vector2& direction) {
  const double to_x = item.ax - origin.x();
  const double to_y = item.ay - origin.y();
  const double across = direction.x() * item.dy - direction.y() * item.dx;
  const double distance = (to_x * item.dy - to_y * item.dx) / across;
  const double place = (to_x * direction.y() - to_y * direction.x()) / across;
  const bool is_met = distance > 0.0 && place >= 0.0 && place <= 1.0;  // parallel: NaN, not met
  return is_met ? distance : std::numeric_limits<double>::infinity();
}

RayHit Rays::first(const Vector2& origin, const Vector2& direction) const {
  RayHit hit;
  if (lines_.empty()) return hit;
  // Where the ray comes into the cells, and where it leaves them.
  const Vector2 size(columns_ * cell_, rows_ * cell_);
  double enters = 0.0;
  double leaves = std::numeric_limits<double>::infinity();
  for (const int axis : {0, 1}) {
    const double from = corner_[axis] - origin[axis];
    if (direction[axis] == 0.0) {
      if (from > 0.0 || from + size[axis] < 0.0) return hit;
      continue;
    }
    const double one = from / direction[axis];
    const double other = (from + size[axis]) / direction[axis];
    enters = std::max(enters, std::min(one, other));
    leaves = std::min(leaves, std::max(one, other));
  }
  if (enters > leaves) return hit;
  const Vector2 place = (origin + enters * direction - corner_) / cell_;
  int at[2] = {std::clamp(static_cast<int>(place.x()), 0, columns_ - 1),
               std::clamp(static_cast<int>(place.y()), 0, rows_ - 1)};
  const int count[2] = {columns_, rows_};
  int step[2];
  double next[2];   // [m] along the ray, to the next cell of each axis
  double width[2];  // [m] along the ray, of a cell
  for (const int axis : {0, 1}) {
    step[axis] = direction[axis] < 0.0 ? -1 : 1;
    const double edge = corner_[axis] + cell_ * (at[axis] + (step[axis] > 0 ? 1 : 0));
    const bool is_still = direction[axis] == 0.0;
    const double never = std::numeric_limits<double>::infinity();
    next[axis] = is_still ? never : (edge - origin[axis]) / direction[axis];
    width[axis] = is_still ? never : cell_ / std::abs(direction[axis]);
  }
  while (true) {
    const std::size_t cell = cell_at(at[0], at[1]);
    for (std::size_t i = begins_[cell]; i < begins_[cell + 1]; ++i) {
      const double distance = distance_to(in_cells_[i], origin, direction);
      if (distance < hit.distance) hit = {in_cells_[i].line, distance};
    }
    const int axis = next[0] < next[1] ? 0 : 1;
    if (hit.distance <= next[axis]) return hit;
    at[axis] += step[axis];
    if (at[axis] < 0 || at[axis] >= count[axis]) return hit;
    next[axis] += width[axis];
  }
}

}  // namespace perceptor::localize
