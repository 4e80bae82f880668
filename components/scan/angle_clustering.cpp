#include "components/scan/angle_clustering.hpp"

#include <algorithm>
#include <cmath>

#include "components/scan/merging.hpp"

namespace perceptor::scan {
namespace {

/// Variance of a point across a direction [m^2].
double variance_across(const ResampledPoint& point, const Vector2& direction) {
  const double across = cross(point.along, direction);
  return point.variance * across * across;
}

/// A direction from one point to another, with the variance of its angle [rad^2].
struct Step {
  Vector2 direction;
  double variance;
};

Step step_between(const ResampledPoint& from, const ResampledPoint& to) {
  const Vector2 difference = to.location - from.location;
  const Vector2 direction = unit(difference);
  const double variance = variance_across(from, direction) + variance_across(to, direction);
  return {.direction = direction, .variance = variance / difference.squaredNorm()};
}

bool turns(const Step& mean, const Step& next, const ClusterParameters& cluster) {
  const double turn = std::abs(
      std::atan2(cross(mean.direction, next.direction), mean.direction.dot(next.direction)));
  const double noise = cluster.turn_sigmas * std::sqrt(mean.variance + next.variance);
  return turn > std::max(cluster.min_turn, noise);
}

/// Adds the clusters of the beams begin to end - 1.
void cluster_stretch(const Sweep& sweep, const Run& stretch, const ClusterParameters& cluster,
                     std::vector<ResampledPoint>& points, std::vector<Run>& runs) {
  resample(sweep.beams, stretch.begin, stretch.end, cluster, points);
  std::size_t first = 0;
  for (std::size_t last = 1; last + 1 < points.size(); ++last) {
    if (last == first) continue;
    const Step mean = step_between(points[first], points[last]);
    const Step next = step_between(points[last], points[last + 1]);
    if (!turns(mean, next, cluster)) continue;
    runs.push_back(make_run(sweep.sums, points[first].begin, points[last].end));
    first = last + 1;
  }
  runs.push_back(make_run(sweep.sums, points[first].begin, stretch.end));
}

}  // namespace

void angle_clustering(const Sweep& sweep, const ScanParameters& parameters, Workspace& workspace,
                      std::vector<Run>& runs) {
  for (const Run& stretch : sweep.stretches)
    cluster_stretch(sweep, stretch, parameters.angle_clustering, workspace.points, runs);
  merge_over_strays(runs, sweep.beams, parameters, workspace.gains);
}

}  // namespace perceptor::scan
