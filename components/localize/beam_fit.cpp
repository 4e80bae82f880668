#include "components/localize/beam_fit.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace perceptor::localize {
namespace {

double normal_density(double difference, double sigma) {
  const double z = difference / sigma;
  return std::exp(-z * z / 2.0) / (sigma * std::sqrt(2.0 * std::numbers::pi));
}

/// Density of a range [1/m]. A door is either shut or open, for all its beams: which of the two is
/// what fits better, beam by beam, and costs nothing, so that a shut door is worth as much as a
/// wall.
double density(double range, const Met& met, const BeamFitParameters& parameters) {
  const bool is_behind = range > met.face + parameters.through;
  const double anything =
      (is_behind ? parameters.behind : parameters.anything) / parameters.max_range;
  const double at_door = normal_density(range - met.door, parameters.sigma);
  const double at_face = normal_density(range - met.face, parameters.sigma);
  const double in_front = range < met.face ? parameters.in_front / met.face : 0.0;
  return anything + in_front + parameters.hit * std::max(at_door, at_face);
}

/// Neighbouring beams that end on one thing seen at this angle or less grazing differ by no more.
constexpr double kGrazing = 0.1;  // [rad]
constexpr double kRough = 0.1;    // [m] noise of two ranges, and what is not straight

bool end_together(const Beam& beam, const Beam& next) {
  const double between = std::abs(cross(beam.direction, next.direction));
  const double nearer = std::min(beam.range, next.range);
  return std::abs(beam.range - next.range) < kRough + nearer * between / kGrazing;
}

}  // namespace

std::vector<Beam> choose_beams(const std::vector<BeamEnd>& ends, int count) {
  std::vector<Beam> all;
  all.reserve(ends.size());
  for (const BeamEnd& end : ends) {
    const Vector2 along = end.location - end.origin;
    all.push_back({end.origin, unit(along), along.norm()});
  }
  std::vector<Beam> beams;
  const std::size_t wanted = std::min(static_cast<std::size_t>(count), all.size());
  for (std::size_t k = 0; k < wanted; ++k) {
    const std::size_t i = (2 * k + 1) * all.size() / (2 * wanted);
    const bool is_alone = (i == 0 || !end_together(all[i - 1], all[i])) &&
                          (i + 1 == all.size() || !end_together(all[i], all[i + 1]));
    if (!is_alone) beams.push_back(all[i]);
  }
  return beams;
}

BeamFit fit_beams(const World& world, const Position& robot_in_world,
                  const std::vector<Beam>& beams, const BeamFitParameters& parameters) {
  BeamFit fit;
  if (beams.empty()) return fit;
  const double near = kHitSigmas * parameters.sigma;
  const double cosine = std::cos(robot_in_world.a);
  const double sine = std::sin(robot_in_world.a);
  const auto rotated = [&](const Vector2& v) {
    return Vector2(cosine * v.x() - sine * v.y(), sine * v.x() + cosine * v.y());
  };
  int explained = 0;
  int through = 0;
  for (const Beam& beam : beams) {
    const Met met = world.meet(robot_in_world.location() + rotated(beam.origin),
                               rotated(beam.direction), beam.range);
    fit.log_likelihood += std::log(density(beam.range, met, parameters));
    if (std::abs(beam.range - met.face) < near || std::abs(beam.range - met.door) < near)
      ++explained;
    if (beam.range > met.face + parameters.through) ++through;
  }
  fit.explained = explained / static_cast<double>(beams.size());
  fit.through = through / static_cast<double>(beams.size());
  return fit;
}

}  // namespace perceptor::localize
