#include "components/localize/rays.hpp"

#include <algorithm>
#include <cmath>

#include "common/geometry/interval.hpp"

namespace perceptor::localize {
namespace {

constexpr double kLeastCell = 0.5;       // [m]
constexpr double kMostCells = 40'000.0;  // of a building however large
constexpr double kMargin = 1e-6;         // [m] lines on the edge of a cell are in both

/// A ray along one axis of the cells: places in cells, its way in metres.
class Axis {
 public:
  Axis(double from, double speed)
      : from_(from), speed_(speed), per_cell_(1.0 / speed), is_backward_(speed < 0.0) {}

  double at(double way) const { return from_ + way * speed_; }

  /// The cell behind so many.
  int behind(int cell, int leap) const { return is_backward_ ? cell - leap : cell + leap; }

  /// To the edge of that cell.
  double way_behind(int cell, int leap) const {
    return way_to(is_backward_ ? cell - leap + 1 : cell + leap);
  }

  /// Where the ray is within `count` cells; empty where it never is.
  Interval way_within(int count) const {
    if (speed_ == 0.0)
      return from_ < 0.0 || from_ > count ? Interval{kNever, 0.0} : Interval{0.0, kNever};
    return {way_to(is_backward_ ? count : 0), way_to(is_backward_ ? 0 : count)};
  }

 private:
  static constexpr double kNever = std::numeric_limits<double>::infinity();

  double way_to(int place) const { return speed_ == 0.0 ? kNever : (place - from_) * per_cell_; }

  double from_;      // [cells]
  double speed_;     // [cells/m]
  double per_cell_;  // [m]
  bool is_backward_;
};

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

void Rays::add(const Segment& segment) { lines_.push_back(item_of(segment, lines_.size())); }

void Rays::add_opening(const Segment& segment) {
  openings_.push_back(item_of(segment, openings_.size()));
}

Rays::Item Rays::item_of(const Segment& segment, std::size_t line) {
  const Vector2 along = segment.b - segment.a;
  return {segment.a.x(), segment.a.y(), along.x(), along.y(), line};
}

std::size_t Rays::cell_at(int column, int row) const {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
         static_cast<std::size_t>(column);
}

void Rays::sort() {
  cells_.clear();
  in_cells_.clear();
  if (lines_.empty() && openings_.empty()) return;
  lay_cells();
  const auto filled = [this] { return static_cast<std::uint32_t>(in_cells_.size()); };
  for (int row = 0; row < rows_; ++row)
    for (int column = 0; column < columns_; ++column) {
      const Vector2 low = corner_ + cell_ * Vector2(column, row) - Vector2(kMargin, kMargin);
      const Vector2 high = low + Vector2(cell_ + 2.0 * kMargin, cell_ + 2.0 * kMargin);
      Cell& cell = cells_.emplace_back();
      cell.begin = filled();
      add_to_cell(lines_, low, high);
      cell.openings = filled();
      add_to_cell(openings_, low, high);
      cell.end = filled();
    }
  measure_leaps();
}

/// Over all lines.
void Rays::lay_cells() {
  corner_ = Vector2::Constant(std::numeric_limits<double>::infinity());
  Vector2 far = -corner_;
  for (const auto* items : {&lines_, &openings_})
    for (const Item& item : *items)
      for (const Vector2& end :
           {Vector2(item.ax, item.ay), Vector2(item.ax + item.dx, item.ay + item.dy)}) {
        corner_ = corner_.cwiseMin(end);
        far = far.cwiseMax(end);
      }
  corner_ -= Vector2(kMargin, kMargin);
  const Vector2 size = far - corner_ + Vector2(kMargin, kMargin);
  cell_ = std::max(kLeastCell, std::sqrt(size.x() * size.y() / kMostCells));
  cell_ = std::max(cell_, std::max(size.x(), size.y()) / kMostCells);
  columns_ = static_cast<int>(size.x() / cell_) + 1;
  rows_ = static_cast<int>(size.y() / cell_) + 1;
}

/// Those that have a point between `low` and `high`.
void Rays::add_to_cell(const std::vector<Item>& items, const Vector2& low, const Vector2& high) {
  for (const Item& item : items)
    if (reaches({{item.ax, item.ay}, {item.ax + item.dx, item.ay + item.dy}}, low, high))
      in_cells_.push_back(item);
}

/// The distance to the nearest cell with a line in it, a diagonal step as long as a straight one
/// (A. Rosenfeld and J. Pfaltz, "Sequential operations in digital picture processing", JACM 1966).
void Rays::measure_leaps() {
  for (Cell& cell : cells_) cell.leap = cell.begin < cell.end ? 0 : std::max(columns_, rows_);
  const auto sweep = [&](int column, int row, int back) {
    int& leap = cells_[cell_at(column, row)].leap;
    const auto pass = [&](int x, int y) {
      if (x >= 0 && x < columns_ && y >= 0 && y < rows_)
        leap = std::min(leap, cells_[cell_at(x, y)].leap + 1);
    };
    pass(column - back, row);
    for (const int x : {column - 1, column, column + 1}) pass(x, row - back);
  };
  for (int row = 0; row < rows_; ++row)
    for (int column = 0; column < columns_; ++column) sweep(column, row, 1);
  for (int row = rows_ - 1; row >= 0; --row)
    for (int column = columns_ - 1; column >= 0; --column) sweep(column, row, -1);
  for (Cell& cell : cells_) cell.leap = std::max(cell.leap, 1);
}

double Rays::distance_to(const Item& item, const Vector2& origin, const Vector2& direction) {
  const double to_x = item.ax - origin.x();
  const double to_y = item.ay - origin.y();
  const double across = direction.x() * item.dy - direction.y() * item.dx;
  const double place = to_x * direction.y() - to_y * direction.x();  // times across, as distance
  const double distance = to_x * item.dy - to_y * item.dx;
  const bool is_met = across > 0.0 ? distance > 0.0 && place >= 0.0 && place <= across
                                   : distance < 0.0 && place <= 0.0 && place >= across;
  return is_met ? distance / across : std::numeric_limits<double>::infinity();
}

RayHit Rays::first(const Vector2& origin, const Vector2& direction, double range) const {
  RayHit hit;
  if (cells_.empty()) return hit;
  const Axis x((origin.x() - corner_.x()) / cell_, direction.x() / cell_);
  const Axis y((origin.y() - corner_.y()) / cell_, direction.y() / cell_);
  const Interval in_columns = x.way_within(columns_);
  const Interval in_rows = y.way_within(rows_);
  const double end = std::min(in_columns.to, in_rows.to);
  double way = std::max({0.0, in_columns.from, in_rows.from});
  if (way > end) return hit;
  int column = std::clamp(static_cast<int>(x.at(way)), 0, columns_ - 1);
  int row = std::clamp(static_cast<int>(y.at(way)), 0, rows_ - 1);
  while (true) {
    const Cell& cell = cells_[cell_at(column, row)];
    for (std::uint32_t i = cell.begin; i < cell.openings; ++i) {
      const double distance = distance_to(in_cells_[i], origin, direction);
      if (distance < hit.distance) {
        hit.line = in_cells_[i].line;
        hit.distance = distance;
      }
    }
    const double to_column = x.way_behind(column, cell.leap);
    const double to_row = y.way_behind(row, cell.leap);
    const bool is_along_x = to_column < to_row;
    way = std::min(to_column, to_row);
    for (std::uint32_t i = cell.openings; i < cell.end; ++i) {
      const double distance = distance_to(in_cells_[i], origin, direction);
      if (distance <= way && distance < hit.distance &&
          std::abs(range - distance) < std::abs(range - hit.opening))
        hit.opening = distance;
    }
    if (hit.distance <= way || way > end) return hit;
    const int beside = cell.leap - 1;
    const int beside_x = std::clamp(static_cast<int>(x.at(way)), column - beside, column + beside);
    const int beside_y = std::clamp(static_cast<int>(y.at(way)), row - beside, row + beside);
    column = is_along_x ? x.behind(column, cell.leap) : beside_x;
    row = is_along_x ? beside_y : y.behind(row, cell.leap);
    if (column < 0 || column >= columns_ || row < 0 || row >= rows_) return hit;
  }
}

}  // namespace perceptor::localize
