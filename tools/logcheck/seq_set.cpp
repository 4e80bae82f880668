#include "tools/logcheck/seq_set.hpp"

#include <iterator>

namespace perceptor {

bool SeqSet::add(std::int64_t seq) {
  auto after = runs_.upper_bound(seq);
  if (after != runs_.begin()) {
    auto run = std::prev(after);
    if (seq <= run->second) return false;
    if (seq == run->second + 1) {
      run->second = seq;
      const bool touches_next = after != runs_.end() && after->first == seq + 1;
      if (touches_next) {
        run->second = after->second;
        runs_.erase(after);
      }
      return true;
    }
  }
  std::int64_t last = seq;
  if (after != runs_.end() && after->first == seq + 1) {
    last = after->second;
    after = runs_.erase(after);
  }
  runs_.emplace_hint(after, seq, last);
  return true;
}

std::vector<SeqRange> SeqSet::gaps() const {
  std::vector<SeqRange> gaps;
  for (auto run = runs_.begin(); run != runs_.end(); ++run) {
    const auto next = std::next(run);
    if (next != runs_.end()) gaps.push_back({run->second + 1, next->first - 1});
  }
  return gaps;
}

}  // namespace perceptor
