#include "components/scan/merging.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace perceptor::scan {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Stands for a gain that has to be computed again.
constexpr double kStale = std::numeric_limits<double>::quiet_NaN();
/// Stands for the gain of a pair that is to be merged.
constexpr double kMerge = -kInfinity;

/// Of leaving the two apart [-]; negative where they are one wall.
double gain_of(const Run& first, const Run& second, const Beams& beams,
               const ScanParameters& parameters) {
  return is_bridgeable(beams, first, second)
             ? gain_of_cut(first.moments, second.moments, parameters)
             : kInfinity;
}

/// gains[i] stands between run i and the next; after the last of a circle the first is next.
void update(std::vector<double>& gains, const std::vector<Run>& runs, const Beams& beams,
            const ScanParameters& parameters) {
  for (std::size_t i = 0; i + 1 < runs.size(); ++i)
    if (std::isnan(gains[i])) gains[i] = gain_of(runs[i], runs[i + 1], beams, parameters);
  gains.back() = beams.is_circle && runs.size() > 2
                     ? gain_of(runs.back(), past_seam(runs.front(), beams), beams, parameters)
                     : kInfinity;
}

/// Marks every pair that gains less apart than both pairs beside it.
void mark_best(std::vector<double>& gains) {
  const std::size_t size = gains.size();
  for (std::size_t i = 0; i < size; ++i) {
    const double before = gains[(i + size - 1) % size];
    const double after = gains[(i + 1) % size];
    if (gains[i] < 0.0 && gains[i] < before && gains[i] <= after) gains[i] = kMerge;
  }
}

/// Merges the marked pairs; whether there was one.
bool merge_marked(std::vector<Run>& runs, std::vector<double>& gains, const Beams& beams) {
  if (gains.back() == kMerge) {
    turn(runs, beams);
    std::ranges::rotate(gains, gains.begin() + 1);
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < runs.size(); ++i, ++kept) {
    const bool merges = gains[i] == kMerge;
    runs[kept] = merges ? joined(runs[i], runs[i + 1]) : runs[i];
    gains[kept] = merges ? kStale : gains[i];
    if (!merges) continue;
    if (kept > 0) gains[kept - 1] = kStale;
    ++i;
  }
  const bool merged = kept < runs.size();
  runs.resize(kept);
  gains.resize(kept);
  return merged;
}

void remove_small(std::vector<Run>& runs) {
  std::erase_if(runs, [](const Run& run) { return run.size() <= kMostStrays; });
}

}  // namespace

void merge_neighbours(std::vector<Run>& runs, const Beams& beams, const ScanParameters& parameters,
                      std::vector<double>& gains) {
  if (runs.empty()) return;
  gains.assign(runs.size(), kStale);
  do {
    update(gains, runs, beams, parameters);
    mark_best(gains);
  } while (merge_marked(runs, gains, beams));
}

void merge_over_strays(std::vector<Run>& runs, const Beams& beams, const ScanParameters& parameters,
                       std::vector<double>& gains) {
  merge_neighbours(runs, beams, parameters, gains);
  remove_small(runs);
  merge_neighbours(runs, beams, parameters, gains);
}

}  // namespace perceptor::scan
