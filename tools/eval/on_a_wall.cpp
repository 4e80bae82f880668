#include "tools/eval/on_a_wall.hpp"

#include <algorithm>
#include <cmath>

namespace perceptor {

bool is_on_a_wall(const Segment& found, const std::vector<Segment>& walls,
                  const OnAWallParameters& parameters) {
  const auto on_one_that_runs_alike = [&](const Vector2& point) {
    return std::ranges::any_of(walls, [&](const Segment& wall) {
      return length(wall) > 0.0 && smallest_relative_angle(wall, found) < parameters.max_angle &&
             distance(wall, point) < parameters.max_offset;
    });
  };
  const auto steps = static_cast<int>(std::ceil(length(found) / parameters.step));
  for (int i = 0; i <= steps; ++i) {
    const double share = steps > 0 ? static_cast<double>(i) / steps : 0.0;
    if (!on_one_that_runs_alike(found.a + share * (found.b - found.a))) return false;
  }
  return true;
}

}  // namespace perceptor
