/// @file Random geometry for the laws that hold for any; the seed is fixed.
#pragma once

#include <numbers>
#include <random>

#include "common/geometry/segment.hpp"

namespace perceptor {

inline constexpr int kTries = 2000;

class RandomScene {
 public:
  double number(double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random_);
  }
  double heading() { return number(-std::numbers::pi, std::numbers::pi); }
  Vector2 point() { return {number(-10.0, 10.0), number(-10.0, 10.0)}; }
  Position position() { return {number(-10.0, 10.0), number(-10.0, 10.0), heading()}; }
  Segment segment() { return {point(), point()}; }

 private:
  std::mt19937_64 random_{1};
};

}  // namespace perceptor
