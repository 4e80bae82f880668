/// @file Which of the numbers 0, 1, .. belong together (Tarjan 1975, by path halving).
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace perceptor::global_map {

class DisjointSets {
 public:
  explicit DisjointSets(std::size_t size) : parent_(size) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }

  /// The smallest of the set that a number is in.
  std::size_t find(std::size_t number) {
    while (parent_[number] != number) number = parent_[number] = parent_[parent_[number]];
    return number;
  }

  void join(std::size_t p, std::size_t q) {
    const std::size_t first = find(p);
    const std::size_t second = find(q);
    parent_[std::max(first, second)] = std::min(first, second);
  }

 private:
  std::vector<std::size_t> parent_;
};

}  // namespace perceptor::global_map
