/// @file The sides of a hallway, seen along it from the robot. Parts of hallway.cpp.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "common/geometry/interval.hpp"
#include "components/identify/hallway.hpp"

namespace perceptor::identify {

/// A wall of a side, seen along the hallway from the robot.
struct Piece {
  const Wall* wall = nullptr;
  Interval along;                  ///< [m] along the hallway
  std::array<double, 2> offset{};  ///< [m] to the left, at the interval's ends

  double middle_offset() const { return 0.5 * (offset[0] + offset[1]); }
  double offset_at(double place) const {
    return offset[0] + (offset[1] - offset[0]) * (place - along.from) / along.length();
  }
};
using Side = std::vector<Piece>;

/// Looking along a wall, which is on the left.
class View {
 public:
  View(Vector2 robot, const Wall& wall)
      : robot_(std::move(robot)), along_(perpendicular(wall.free)), left_(-wall.free) {}

  Piece piece(const Wall& wall) const {
    const Vector2 a = wall.ends[0].location - robot_;
    const Vector2 b = wall.ends[1].location - robot_;
    Piece piece{&wall, {along_.dot(a), along_.dot(b)}, {left_.dot(a), left_.dot(b)}};
    if (piece.along.from > piece.along.to) {
      std::swap(piece.along.from, piece.along.to);
      std::swap(piece.offset[0], piece.offset[1]);
    }
    return piece;
  }
  Vector2 place(double along, double left) const { return robot_ + along * along_ + left * left_; }
  const Vector2& left() const { return left_; }

 private:
  Vector2 robot_;
  Vector2 along_;
  Vector2 left_;
};

/// Those that run along, and look at the robot from the left (+1) or from the right (-1).
/// Sorted by where they begin.
Side facing_pieces(const std::vector<Wall>& walls, const View& view, double side,
                   const HallwayParameters& parameters);

/// Those of the sorted pieces that are in one line with one of them, and joined to it by others
/// or across gaps no wider than a doorway. Never empty.
Side side_along(const Side& pieces, const Piece& seed, const HallwayParameters& parameters);

/// From the first piece's beginning to the last end.
Interval extent(const Side& side);

/// [m] of the interval that is wall.
double covered(const Side& side, const Interval& interval);

/// [m] to the left, mean over what is wall in the interval.
double mean_offset(const Side& side, const Interval& interval);

}  // namespace perceptor::identify
