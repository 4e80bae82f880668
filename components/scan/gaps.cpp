#include "components/scan/gaps.hpp"

#include <algorithm>
#include <numbers>

#include <Eigen/Core>

namespace perceptor::scan {
namespace {

/// Steps of bearing from which beams are missing in between.
constexpr double kMissingSteps = 1.5;

/// Standard deviations by which noise alone may set two ranges apart.
constexpr double kNoiseSigmas = 3.0 * std::numbers::sqrt2;

/// How far apart two beams may be on one wall.
struct StepLimit {
  double noise;    ///< [m] that two ranges may differ by, at range zero
  double growth;   ///< [m/m] of that
  double grazing;  ///< [-] see Beams
  double missing;  ///< [rad] a larger step misses beams
  double hole;     ///< [m] where beams are missing

  explicit StepLimit(const Beams& beams)
      : noise(kNoiseSigmas * beams.range_sigma),
        growth(kNoiseSigmas * beams.sigma_growth),
        grazing(beams.grazing),
        missing(kMissingSteps * beams.increment),
        hole(beams.max_hole) {}

  /// [m]
  double between(double range, double next_range, double step) const {
    const double noise_here = noise + growth * std::max(range, next_range);
    const double reach = std::min(range, next_range) * step * grazing;
    return noise_here + (step > missing ? std::min(reach, hole) : reach);
  }
};

/// Squared distance of beam j from the earlier beam i, less that of the largest step [m^2].
inline double excess_of_step(const Beams& beams, const StepLimit& limit, std::size_t i,
                             std::size_t j) {
  const double dx = beams.x[j] - beams.x[i];
  const double dy = beams.y[j] - beams.y[i];
  const double most =
      limit.between(beams.range[i], beams.range[j], beams.bearing[j] - beams.bearing[i]);
  return dx * dx + dy * dy - most * most;
}

}  // namespace

bool is_gap(const Beams& beams, std::size_t i, std::size_t j) {
  return excess_of_step(beams, StepLimit(beams), i, j) > 0.0;
}

void Gaps::reserve(std::size_t beams) {
  excess_.reserve(beams);
  gaps_.reserve(beams);
  strays_.reserve(beams);
}

void Gaps::find(Beams& beams) {
  look_at_steps(beams);
  list_gaps(beams.count);
  find_strays(beams);
  if (strays_.empty()) return;
  take_out_strays(beams);
  list_gaps(beams.count);
}

void Gaps::look_at_steps(const Beams& beams) {
  const StepLimit limit(beams);
  excess_.assign(std::max<std::size_t>(beams.count, 1), 0.0);
  for (std::size_t i = 1; i < beams.count; ++i) excess_[i] = excess_of_step(beams, limit, i - 1, i);
}

/// Most steps are none, so they are passed over by the block.
void Gaps::list_gaps(std::size_t count) {
  constexpr std::size_t kBlock = 16;
  gaps_.clear();
  for (std::size_t block = 0; block < count; block += kBlock) {
    const std::size_t end = std::min(block + kBlock, count);
    const Eigen::Map<const Eigen::ArrayXd> excess(excess_.data() + block,
                                                  static_cast<Eigen::Index>(end - block));
    if (excess.maxCoeff() <= 0.0) continue;
    for (std::size_t i = block; i < end; ++i)
      if (excess_[i] > 0.0) gaps_.push_back(i);
  }
}

/// Each beam by the two beside it as they were measured, so that no stray comes first.
void Gaps::find_strays(const Beams& beams) {
  strays_.clear();
  for (std::size_t k = 0; k + 1 < gaps_.size(); ++k) {
    const std::size_t i = gaps_[k];
    if (gaps_[k + 1] == i + 1 && !is_gap(beams, i - 1, i + 1)) strays_.push_back(i);
  }
}

void Gaps::take_out_strays(Beams& beams) {
  const StepLimit limit(beams);
  std::size_t kept = strays_.front();
  auto stray = strays_.begin();
  for (std::size_t i = kept; i < beams.count; ++i) {
    if (stray != strays_.end() && *stray == i) {
      *stray++ = beams.beam[i];
      continue;
    }
    const bool follows_stray = stray != strays_.begin() && kept > 0;
    beams.x[kept] = beams.x[i];
    beams.y[kept] = beams.y[i];
    beams.range[kept] = beams.range[i];
    beams.weight[kept] = beams.weight[i];
    beams.bearing[kept] = beams.bearing[i];
    beams.beam[kept] = beams.beam[i];
    excess_[kept] = follows_stray ? excess_of_step(beams, limit, kept - 1, kept) : excess_[i];
    ++kept;
  }
  beams.count = kept;
}

}  // namespace perceptor::scan
