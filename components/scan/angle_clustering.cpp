#include "components/scan/angle_clustering.hpp"

#include <algorithm>
#include <cmath>

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

}  // namespace

double spacing(const Beam& beam, const ClusterParameters& cluster) {
  return std::max(cluster.min_spacing, cluster.spacing_sigmas * beam.sigma);
}

std::vector<ResampledPoint> resample(const Beams& beams, std::size_t begin, std::size_t end,
                                     const ClusterParameters& cluster) {
  std::vector<ResampledPoint> points;
  for (std::size_t first = begin; first < end;) {
    const double least = spacing(beams[first], cluster);
    Vector2 sum = beams[first].location;
    std::size_t i = first + 1;
    while (i < end && (beams[i].location - beams[first].location).squaredNorm() < least * least)
      sum += beams[i++].location;
    const auto beams_in_it = static_cast<double>(i - first);
    points.push_back({.location = sum / beams_in_it,
                      .along = beams[first].along,
                      .variance = beams[first].sigma * beams[first].sigma / beams_in_it,
                      .begin = first,
                      .end = i});
    first = i;
  }
  return points;
}

std::vector<std::size_t> angle_clusters(const Beams& beams, std::size_t begin, std::size_t end,
                                        const ClusterParameters& cluster) {
  const std::vector<ResampledPoint> points = resample(beams, begin, end, cluster);
  std::vector<std::size_t> begins = {begin};
  std::size_t first = 0;
  for (std::size_t last = 1; last + 1 < points.size(); ++last) {
    if (last == first) continue;
    const Step mean = step_between(points[first], points[last]);
    const Step next = step_between(points[last], points[last + 1]);
    if (!turns(mean, next, cluster)) continue;
    first = last + 1;
    begins.push_back(points[first].begin);
  }
  return begins;
}

}  // namespace perceptor::scan
