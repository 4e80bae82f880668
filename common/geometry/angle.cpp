#include "common/geometry/angle.hpp"

#include <cmath>
#include <numbers>

namespace perceptor {

double wrap_angle(double angle) {
  constexpr double pi = std::numbers::pi;
  const bool is_wrapped = -pi < angle && angle <= pi;
  if (is_wrapped) return angle;
  const double wrapped = std::remainder(angle, 2.0 * pi);
  return wrapped <= -pi ? pi : wrapped;
}

double angle_difference(double from, double to) { return wrap_angle(to - from); }

}  // namespace perceptor
