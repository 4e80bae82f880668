#include "components/scan/beams.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/geometry/polygon.hpp"

namespace perceptor::scan {
namespace {

/// No range is better known than this [m]: keeps weights finite where a scan claims no noise.
constexpr double kSmallestSigma = 1e-4;

/// Steps of bearing from which beams are missing in between.
constexpr double kMissingSteps = 1.5;

/// Standard deviations by which noise alone may set two ranges apart.
constexpr double kNoiseSigmas = 3.0 * std::numbers::sqrt2;

Beam make_beam(const LaserScan& scan, const BeamEnd& end, const NoiseParameters& noise) {
  const double growth = noise.sigma_growth * end.range;
  const double sigma = std::sqrt(scan.range_sigma * scan.range_sigma + growth * growth);
  return {.location = end.location,
          .along = (end.location - end.origin) / end.range,
          .range = end.range,
          .sigma = std::max(sigma, kSmallestSigma),
          .bearing = scan.bearings[end.beam]};
}

/// Counter-clockwise [rad].
double step_between(const Beam& from, const Beam& to) {
  const double step = to.bearing - from.bearing;
  return step < 0.0 ? step + 2.0 * std::numbers::pi : step;
}

bool is_gap(const Beams& beams, const Beam& from, const Beam& to, double step) {
  const double distance_squared = (to.location - from.location).squaredNorm();
  const double noise = kNoiseSigmas * std::max(from.sigma, to.sigma);
  const double nearer = std::min(from.range, to.range);
  const double reach = noise + nearer * step * beams.grazing;
  const bool beams_are_missing = step > kMissingSteps * beams.increment;
  const double limit = beams_are_missing ? std::min(reach, noise + beams.max_hole) : reach;
  return distance_squared > limit * limit;
}

/// Beams that jump away from both neighbours, which belong together.
void remove_strays(Beams& usable) {
  std::vector<Beam>& beams = usable.beams;
  if (beams.size() < 3) return;
  const auto jumps = [&usable](const Beam& from, const Beam& to) {
    return is_gap(usable, from, to, step_between(from, to));
  };
  std::size_t kept = 1;
  for (std::size_t i = 1; i < beams.size(); ++i) {
    const bool is_last = i + 1 == beams.size();
    const bool is_stray = !is_last && jumps(beams[kept - 1], beams[i]) &&
                          jumps(beams[i], beams[i + 1]) && !jumps(beams[kept - 1], beams[i + 1]);
    if (!is_stray) beams[kept++] = beams[i];
  }
  beams.resize(kept);
}

/// The farthest end in view lies at a corner, whatever the room: the one place to begin at
/// that does not depend on where the sweep began.
void begin_at_farthest(std::vector<Beam>& beams) {
  const auto farthest = std::ranges::max_element(beams, {}, &Beam::range);
  std::ranges::rotate(beams, farthest);
}

}  // namespace

bool is_gap(const Beams& beams, std::size_t i, std::size_t j) {
  return is_gap(beams, beams[i], beams[j], step_between(beams[i], beams[j]));
}

double variance_across(const Beam& beam, const Vector2& normal, const NoiseParameters& noise) {
  const double across = beam.sigma * beam.along.dot(normal);
  return across * across + noise.surface_roughness * noise.surface_roughness;
}

double distance_between_beams(const Beams& beams, const Beam& beam, const Vector2& normal) {
  const double incidence = std::abs(beam.along.dot(normal));
  const double stretched = incidence * beams.grazing > 1.0 ? 1.0 / incidence : beams.grazing;
  return beam.range * beams.increment * stretched;
}

Beams usable_beams(const LaserScan& scan, const Twist& twist, const std::vector<Vector2>& footprint,
                   const ScanParameters& parameters) {
  const std::vector<BeamEnd> ends = beam_ends(scan, twist);
  Beams usable;
  usable.grazing = 1.0 / std::sin(parameters.gap.min_incidence);
  usable.max_hole = parameters.gap.max_hole;
  usable.no_return = scan.size() - ends.size();
  if (ends.empty()) return usable;

  const bool has_footprint = footprint.size() >= 3;
  usable.beams.reserve(ends.size());
  for (const BeamEnd& end : ends) {
    if (has_footprint && contains(footprint, end.location))
      ++usable.in_footprint;
    else
      usable.beams.push_back(make_beam(scan, end, parameters.noise));
  }
  const auto [smallest, largest] = std::ranges::minmax_element(scan.bearings);
  if (scan.size() > 1)
    usable.increment = (*largest - *smallest) / static_cast<double>(scan.size() - 1);
  usable.laser = ends[ends.size() / 2].origin;

  const double around = *largest - *smallest + 2.0 * usable.increment;
  usable.is_circle = usable.beams.size() > 2 && around >= 2.0 * std::numbers::pi;
  if (usable.is_circle) begin_at_farthest(usable.beams);
  remove_strays(usable);
  usable.count = usable.beams.size();
  if (usable.is_circle) {
    usable.beams.resize(2 * usable.count);
    std::copy_n(usable.beams.begin(), usable.count,
                usable.beams.begin() + static_cast<std::ptrdiff_t>(usable.count));
  }
  return usable;
}

}  // namespace perceptor::scan
