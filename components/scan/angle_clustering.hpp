/// @file Cuts a stretch of beams where its direction turns.
///
/// Noise makes the angle between close points useless, so the beams are first resampled:
/// points at least a spacing apart, each the mean of the beams around it. Then, point by point:
///   1. the next angle is the direction from the cluster's last point to the next point;
///   2. the mean angle of the cluster, each step weighted by its length, is the direction from
///      its first point to its last;
///   3. where the two differ by more than noise explains, the cluster ends and another begins.
#pragma once

#include <vector>

#include "components/scan/beams.hpp"

namespace perceptor::scan {

/// Some beams that follow each other, as one point.
struct ResampledPoint {
  Vector2 location{0.0, 0.0};  ///< [m] mean of the beams' ends
  Vector2 along{1.0, 0.0};     ///< direction of the first beam
  double variance = 0.0;       ///< [m^2] of the mean, along the beams
  std::size_t begin = 0;       ///< first beam
  std::size_t end = 0;         ///< after the last beam
};

/// Distance that resampled points keep at this beam [m].
double spacing(const Beam& beam, const ClusterParameters& cluster);

/// The beams begin to end - 1 as points.
std::vector<ResampledPoint> resample(const Beams& beams, std::size_t begin, std::size_t end,
                                     const ClusterParameters& cluster);

/// Where clusters begin among the beams begin to end - 1, `begin` included, in order.
std::vector<std::size_t> angle_clusters(const Beams& beams, std::size_t begin, std::size_t end,
                                        const ClusterParameters& cluster);

}  // namespace perceptor::scan
