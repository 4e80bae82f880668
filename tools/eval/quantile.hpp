/// @file The value that a share of the values does not exceed.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace perceptor {

/// `share` 0.5 gives the median (the lower one of an even number of values), 1 the largest; 0
/// where there are no values.
inline double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  const auto rank = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + rank, values.end());
  return values[static_cast<std::size_t>(rank)];
}

}  // namespace perceptor
