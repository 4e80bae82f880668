/// @file Cuts runs in two, and the parts again, as long as there is a place to cut.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "components/scan/runs.hpp"

namespace perceptor::scan {

/// Appends what remains of each stretch to `runs`, in order. `find_cut(run)` says at which beam a
/// run is to be cut, as std::optional<std::size_t>; `open` is working memory.
template <class FindCut>
void split(const Sweep& sweep, FindCut find_cut, std::vector<Run>& open, std::vector<Run>& runs) {
  for (const Run& stretch : sweep.stretches) {
    open.assign(1, stretch);
    while (!open.empty()) {
      const Run run = open.back();
      open.pop_back();
      const std::optional<std::size_t> cut = find_cut(run);
      if (!cut) {
        runs.push_back(run);
        continue;
      }
      open.push_back(make_run(sweep.sums, *cut, run.end));
      open.push_back(make_run(sweep.sums, run.begin, *cut));
    }
  }
}

}  // namespace perceptor::scan
