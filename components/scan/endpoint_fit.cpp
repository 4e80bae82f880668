#include "components/scan/endpoint_fit.hpp"

#include <algorithm>
#include <optional>

#include "components/scan/merging.hpp"
#include "components/scan/splitting.hpp"

namespace perceptor::scan {
namespace {

/// The line through two beams.
struct Chord {
  Vector2 normal;   ///< unit vector
  double distance;  ///< [m] from the laser, along the normal
};

Chord chord_between(const Beams& beams, std::size_t first, std::size_t last) {
  const Vector2 normal = perpendicular(unit(beams.end(last) - beams.end(first)));
  return {.normal = normal, .distance = normal.dot(beams.end(first))};
}

/// By how much the squared distance from a chord exceeds what a beam's own noise makes of it.
class Excess {
 public:
  Excess(const Beams& beams, const Chord& chord, double sigmas)
      : beams_(beams), chord_(chord), noise_(sigmas * sigmas * chord.distance * chord.distance) {}

  /// [m^2] The largest of the beams begin to end - 1; `at`: which of them that is.
  double largest(std::size_t begin, std::size_t end, Eigen::Index* at = nullptr) const {
    const auto part = [&](const std::vector<double>& array) {
      return Eigen::Map<const Eigen::ArrayXd>(array.data() + begin,
                                              static_cast<Eigen::Index>(end - begin));
    };
    const auto off =
        chord_.normal.x() * part(beams_.x) + chord_.normal.y() * part(beams_.y) - chord_.distance;
    const auto excess = off.square() - noise_ / part(beams_.weight);
    return at != nullptr ? excess.maxCoeff(at) : excess.maxCoeff();
  }

 private:
  const Beams& beams_;
  Chord chord_;
  double noise_;  // [m^2] times the weight of a beam
};

/// The beam farthest beyond what noise explains, if one is. Beams are compared several at a time:
/// the most of each block, then the one in the best block.
std::optional<std::size_t> find_split(const Beams& beams, std::size_t begin, std::size_t end,
                                      const ScanParameters& parameters) {
  constexpr std::size_t kBlock = 32;
  if (end - begin < kFewestBeams) return std::nullopt;
  const Chord chord = chord_between(beams, begin, end - 1);
  const double sigmas = parameters.endpoint_fit.split_sigmas;
  const double noise_of_ends =
      std::max(variance_across(beams, begin, chord.distance, parameters.noise),
               variance_across(beams, end - 1, chord.distance, parameters.noise));
  const double roughness = parameters.noise.surface_roughness;
  const Excess excess(beams, chord, sigmas);

  double most = sigmas * sigmas * (noise_of_ends + roughness * roughness);
  std::optional<std::size_t> best;
  for (std::size_t block = begin; block < end; block += kBlock) {
    const double here = excess.largest(block, std::min(block + kBlock, end));
    if (here <= most) continue;
    most = here;
    best = block;
  }
  if (!best) return std::nullopt;
  Eigen::Index farthest = 0;
  excess.largest(*best, std::min(*best + kBlock, end), &farthest);
  return *best + static_cast<std::size_t>(farthest);
}

}  // namespace

void endpoint_fit(const Sweep& sweep, const ScanParameters& parameters, Workspace& workspace,
                  std::vector<Run>& runs) {
  const auto find_cut = [&](const Run& run) {
    return find_split(sweep.beams, run.begin, run.end, parameters);
  };
  split(sweep, find_cut, workspace.open, runs);
  merge_over_strays(runs, sweep.beams, parameters, workspace.gains);
}

}  // namespace perceptor::scan
