/// @file Beams that follow each other as fewer points, further apart than noise.
#pragma once

#include <vector>

#include "components/scan/beams.hpp"

namespace perceptor::scan {

/// Some beams that follow each other, as one point.
struct ResampledPoint {
  Vector2 location{0.0, 0.0};  ///< [m] mean of the beams' ends, from the laser
  Vector2 along{1.0, 0.0};     ///< direction of the first beam
  double variance = 0.0;       ///< [m^2] of the mean, along the beams
  std::size_t begin = 0;       ///< first beam
  std::size_t end = 0;         ///< after the last beam
};

/// Distance that resampled points keep at this beam [m].
double spacing(const Beams& beams, std::size_t i, const ClusterParameters& cluster);

/// The beams begin to end - 1 as points, which replace those in `points`.
void resample(const Beams& beams, std::size_t begin, std::size_t end,
              const ClusterParameters& cluster, std::vector<ResampledPoint>& points);

}  // namespace perceptor::scan
