/// @file Do two straight pieces cross?
#pragma once

#include "common/geometry/segment.hpp"

namespace perceptor::identify {

/// Whether each piece has its ends on both sides of the other's line. Pieces that only touch
/// do not cross, nor do those in one line.
inline bool cross_each_other(const Segment& s, const Segment& t) {
  const auto separates = [](const Segment& line, const Segment& other) {
    return signed_distance(line, other.a) * signed_distance(line, other.b) < 0.0;
  };
  return separates(s, t) && separates(t, s);
}

}  // namespace perceptor::identify
