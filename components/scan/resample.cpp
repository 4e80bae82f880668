#include "components/scan/resample.hpp"

#include <algorithm>

namespace perceptor::scan {

double spacing(const Beams& beams, std::size_t i, const ClusterParameters& cluster) {
  return std::max(cluster.min_spacing, cluster.spacing_sigmas * beams.sigma(i));
}

void resample(const Beams& beams, std::size_t begin, std::size_t end,
              const ClusterParameters& cluster, std::vector<ResampledPoint>& points) {
  points.clear();
  for (std::size_t first = begin; first < end;) {
    const Vector2 start = beams.end(first);
    const double least = spacing(beams, first, cluster);
    Vector2 sum = start;
    std::size_t i = first + 1;
    while (i < end && (beams.end(i) - start).squaredNorm() < least * least) sum += beams.end(i++);
    const auto beams_in_it = static_cast<double>(i - first);
    const double sigma = beams.sigma(first);
    points.push_back({.location = sum / beams_in_it,
                      .along = unit(start),
                      .variance = sigma * sigma / beams_in_it,
                      .begin = first,
                      .end = i});
    first = i;
  }
}

}  // namespace perceptor::scan
