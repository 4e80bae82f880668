#include "components/localize/unknown_objects.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <Eigen/Eigenvalues>

#include "common/time/stamp.hpp"

namespace perceptor::localize {
namespace {

/// The rectangle along the main axes of some places, and half a cell around it.
std::vector<Vector2> rectangle_around(const std::vector<Vector2>& places, double margin) {
  Vector2 mean = Vector2::Zero();
  for (const Vector2& place : places) mean += place / static_cast<double>(places.size());
  Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
  for (const Vector2& place : places) scatter += (place - mean) * (place - mean).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(scatter);
  const Vector2 along = axes.eigenvectors().col(1);
  const Vector2 across = perpendicular(along);
  Vector2 low = Vector2::Zero();
  Vector2 high = Vector2::Zero();
  for (const Vector2& place : places) {
    const Vector2 seen(along.dot(place - mean), across.dot(place - mean));
    low = low.cwiseMin(seen);
    high = high.cwiseMax(seen);
  }
  low -= Vector2(margin, margin);
  high += Vector2(margin, margin);
  const auto corner = [&](double x, double y) -> Vector2 { return mean + x * along + y * across; };
  return {corner(low.x(), low.y()), corner(high.x(), low.y()), corner(high.x(), high.y()),
          corner(low.x(), high.y())};
}

}  // namespace

UnknownObjects::Key UnknownObjects::key_of(const Vector2& place) const {
  return {static_cast<int>(std::floor(place.x() / parameters_.cell)),
          static_cast<int>(std::floor(place.y() / parameters_.cell))};
}

void UnknownObjects::add(const std::vector<WorldBeam>& beams, const std::vector<bool>& is_unknown,
                         std::int64_t utime) {
  pass(beams);
  for (std::size_t i = 0; i < beams.size(); ++i)
    if (is_unknown[i]) hit(beams[i].origin + beams[i].range * beams[i].direction, utime);
  if (cells_.size() > static_cast<std::size_t>(parameters_.max_cells)) forget_weakest();
}

/// Each cell is looked at by the beam that points at it.
void UnknownObjects::pass(const std::vector<WorldBeam>& beams) {
  if (beams.size() < 2) return;
  const Vector2 ahead = beams[beams.size() / 2].direction;
  const auto bearing = [&](const Vector2& to) {
    return std::atan2(cross(ahead, to), ahead.dot(to));
  };
  std::vector<double> bearings;
  bearings.reserve(beams.size());
  for (const WorldBeam& beam : beams) bearings.push_back(bearing(beam.direction));
  for (auto& [key, cell] : cells_) {
    const Vector2 to = cell.mean - beams.front().origin;
    const auto next = std::ranges::lower_bound(bearings, bearing(to));
    if (next == bearings.begin() || next == bearings.end()) continue;
    const auto i = static_cast<std::size_t>(next - bearings.begin());
    for (const WorldBeam* beam : {&beams[i - 1], &beams[i]}) {
      const bool points_at_it =
          std::abs(cross(beam->direction, cell.mean - beam->origin)) < parameters_.cell / 2.0;
      const double distance = beam->direction.dot(cell.mean - beam->origin);
      if (points_at_it && beam->range > distance + parameters_.behind)
        cell.count -= parameters_.pass;
    }
  }
  std::erase_if(cells_, [](const auto& entry) { return entry.second.count <= 0.0; });
}

void UnknownObjects::hit(const Vector2& place, std::int64_t utime) {
  Cell& cell = cells_[key_of(place)];
  if (cell.hits == 0) cell.first_hit = utime;
  if (cell.hits == 0 || seconds_between(cell.last_hit, utime) > parameters_.pause)
    cell.hit_since = utime;
  cell.last_hit = utime;
  cell.count = std::min(parameters_.most, cell.count + parameters_.hit);
  ++cell.hits;
  cell.mean += (place - cell.mean) / cell.hits;
  if (cell.count >= parameters_.least)
    cell.stayed = std::max(cell.stayed, seconds_between(cell.hit_since, utime));
}

void UnknownObjects::forget_weakest() {
  std::vector<double> counts;
  counts.reserve(cells_.size());
  for (const auto& [key, cell] : cells_) counts.push_back(cell.count);
  const auto half = counts.begin() + static_cast<std::ptrdiff_t>(counts.size() / 2);
  std::nth_element(counts.begin(), half, counts.end());
  std::erase_if(cells_, [&](const auto& entry) { return entry.second.count <= *half; });
}

std::vector<UnknownObject> UnknownObjects::objects(std::int64_t utime) {
  std::vector<Cell*> static_cells;
  std::vector<Cell*> moving_cells;
  for (auto& [key, cell] : cells_) {
    if (cell.stayed >= parameters_.min_age)
      static_cells.push_back(&cell);
    else if (seconds_between(cell.last_hit, utime) <= parameters_.fresh)
      moving_cells.push_back(&cell);
  }
  std::vector<UnknownObject> objects;
  for (auto* left : {&static_cells, &moving_cells}) {
    const bool stay = left == &static_cells;
    while (!left->empty()) {
      // Grows from one cell to all that touch it.
      std::vector<Cell*> own = {left->back()};
      left->pop_back();
      for (std::size_t i = 0; i < own.size(); ++i) {
        const auto touches = [&](const Cell* other) {
          return distance(own[i]->mean, other->mean) <= parameters_.touching;
        };
        const auto apart = std::stable_partition(left->begin(), left->end(),
                                                 [&](const Cell* c) { return !touches(c); });
        own.insert(own.end(), apart, left->end());
        left->erase(apart, left->end());
      }
      const auto stayed = [&](const Cell* cell) { return cell->stayed >= parameters_.few_age; };
      const bool may_be_person = own.size() <= static_cast<std::size_t>(parameters_.few);
      if (stay && may_be_person && std::ranges::none_of(own, stayed)) continue;
      UnknownObject object;
      object.is_static = stay;
      object.first_seen = own.front()->first_hit;
      std::vector<Vector2> places;
      for (const Cell* cell : own) {
        places.push_back(cell->mean);
        object.weight += cell->count;
        object.first_seen = std::min(object.first_seen, cell->first_hit);
        object.last_seen = std::max(object.last_seen, cell->last_hit);
        const bool is_older = cell->id != 0 && (object.id == 0 || cell->id < object.id);
        if (is_older) object.id = cell->id;
      }
      if (object.weight < (stay ? parameters_.object : parameters_.moving)) continue;
      const bool is_taken = std::ranges::any_of(  // one that fell apart: the rest is another
          objects, [&](const UnknownObject& other) { return other.id == object.id; });
      if (object.id == 0 || is_taken) object.id = ++last_id_;
      for (Cell* cell : own) cell->id = object.id;
      object.outline = rectangle_around(places, parameters_.cell / 2.0);
      objects.push_back(std::move(object));
    }
  }
  return objects;
}

}  // namespace perceptor::localize
