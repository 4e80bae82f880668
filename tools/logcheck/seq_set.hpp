/// @file Which sequence numbers have been seen.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

namespace perceptor {

/// Both ends included.
struct SeqRange {
  std::int64_t first = 0;
  std::int64_t last = 0;

  /// first <= last, both from 0 to 2^60.
  std::int64_t size() const { return last - first + 1; }
  friend bool operator==(const SeqRange&, const SeqRange&) = default;
};

/// Numbers of 0 and more, in any order. Memory grows with the number of gaps, not of numbers.
class SeqSet {
 public:
  /// False where it is there already.
  bool add(std::int64_t seq);

  bool empty() const { return runs_.empty(); }
  std::int64_t first() const { return runs_.begin()->first; }   ///< not of an empty set
  std::int64_t last() const { return runs_.rbegin()->second; }  ///< not of an empty set

  /// What lies between the first and the last and is not there.
  std::vector<SeqRange> gaps() const;

 private:
  std::map<std::int64_t, std::int64_t> runs_;  ///< first of a run -> last of it
};

}  // namespace perceptor
