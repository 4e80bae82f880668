#include "components/scan/merging.hpp"

#include <cmath>
#include <limits>

namespace perceptor::scan {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Marks a gain that has to be computed again.
constexpr double kStale = std::numeric_limits<double>::quiet_NaN();

/// Of leaving the two apart [-]; negative where they are one wall.
double gain_of(const Run& first, const Run& second, const Beams& beams,
               const ScanParameters& parameters) {
  return is_bridgeable(beams, first, second)
             ? gain_of_cut(first.moments, second.moments, parameters)
             : kInfinity;
}

/// gains[i] stands between the runs i and i + 1. Merges every pair that gains less apart than
/// both pairs beside it; whether there was one.
bool merge_best(std::vector<Run>& runs, std::vector<double>& gains) {
  std::size_t kept = 0;
  double gain_before = kInfinity;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const double gain = gains[i];
    const bool merges = gain < 0.0 && gain < gain_before && gain <= gains[i + 1];
    gain_before = gain;
    if (!merges) {
      runs[kept] = runs[i];
      gains[kept++] = gain;
      continue;
    }
    runs[kept] = joined(runs[i], runs[i + 1]);
    if (kept > 0) gains[kept - 1] = kStale;
    gain_before = gains[++i];
    gains[kept++] = kStale;
  }
  const bool merged = kept < runs.size();
  runs.resize(kept);
  return merged;
}

void merge_in_line(std::vector<Run>& runs, const Beams& beams, const ScanParameters& parameters,
                   std::vector<double>& gains) {
  if (runs.empty()) return;
  gains.assign(runs.size(), kStale);
  do {
    for (std::size_t i = 0; i + 1 < runs.size(); ++i)
      if (std::isnan(gains[i])) gains[i] = gain_of(runs[i], runs[i + 1], beams, parameters);
    gains[runs.size() - 1] = kInfinity;
  } while (merge_best(runs, gains));
}

}  // namespace

void merge_neighbours(std::vector<Run>& runs, const Beams& beams, const ScanParameters& parameters,
                      std::vector<double>& gains) {
  merge_in_line(runs, beams, parameters, gains);
  if (!beams.is_circle) return;
  turn(runs, beams);
  merge_in_line(runs, beams, parameters, gains);
}

void remove_small(std::vector<Run>& runs) {
  std::erase_if(runs, [](const Run& run) { return run.size() <= kMostStrays; });
}

}  // namespace perceptor::scan
