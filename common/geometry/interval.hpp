/// @file From where to where, along a line.
#pragma once

#include <algorithm>

namespace perceptor {

struct Interval {
  double from = 0.0;
  double to = 0.0;  ///< before `from`: nothing

  double length() const { return to - from; }
  double middle() const { return (from + to) / 2.0; }
  bool contains(double place) const { return from <= place && place <= to; }

  friend bool operator==(const Interval&, const Interval&) = default;
};

inline Interval common_part(const Interval& a, const Interval& b) {
  return {std::max(a.from, b.from), std::min(a.to, b.to)};
}

}  // namespace perceptor
