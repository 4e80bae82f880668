#include "components/merge/wall.hpp"

#include <algorithm>
#include <cmath>

namespace perceptor::merge {

Eigen::Matrix2d moved_along(const Eigen::Matrix2d& covariance, double along) {
  Eigen::Matrix2d move;
  move << 1.0, along, 0.0, 1.0;
  return move * covariance * move.transpose();
}

Eigen::Matrix2d end_covariance(const Wall& wall, const Line& line, std::size_t end) {
  const double to_end = end == kHead ? line.length / 2.0 : -line.length / 2.0;
  const double across = moved_along(wall.covariance, to_end)(0, 0);
  return wall.ends[end].variance * line.along * line.along.transpose() +
         across * line.normal * line.normal.transpose();
}

void set_ends(Wall& wall, const Segment& segment) {
  const Line before = line_of(wall.segment);
  const double shift = before.along.dot(middle(segment) - before.middle);
  wall.covariance = moved_along(wall.covariance, shift);
  wall.segment = segment;
}

bool is_known(const WallEnd& end) { return end.method != CornerMethod::none; }

bool is_seen_as_end(const WallEnd& end) {
  return end.method == CornerMethod::spike || end.method == CornerMethod::vector;
}

double reach_of_seen(const WallEnd& end, const EndParameters& parameters) {
  return std::max(parameters.seen_reach, 2.0 * std::sqrt(end.variance));
}

void sharpen(WallEnd& end, double variance, const EndParameters& parameters) {
  const double floor = parameters.min_sigma * parameters.min_sigma;
  const double sharper = std::min(end.variance, std::max(variance, floor));
  const double smallest_radius = std::min(end.radius, parameters.min_radius);
  end.radius = std::max(smallest_radius, end.radius * std::sqrt(sharper / end.variance));
  end.variance = sharper;
}

void remove_marked(std::vector<Wall>& walls) {
  const auto is_marked = [](const Wall& wall) { return wall.remove; };
  for (const Wall& gone : walls) {
    if (!gone.remove) continue;
    for (Wall& wall : walls)
      for (WallEnd& end : wall.ends)
        if (end.connected == gone.id) end.connected = kNone;
  }
  walls.erase(std::remove_if(walls.begin(), walls.end(), is_marked), walls.end());
}

}  // namespace perceptor::merge
