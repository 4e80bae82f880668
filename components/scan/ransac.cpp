#include "components/scan/ransac.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <utility>

#include "components/scan/merging.hpp"

namespace perceptor::scan {
namespace {

/// Random whole numbers, the same on every machine: the standard's distributions differ between
/// libraries, its generators do not.
class Draw {
 public:
  explicit Draw(std::int64_t seed) : random_(static_cast<std::uint64_t>(seed)) {}

  /// 0 to bound - 1, for bounds up to 2^32.
  std::size_t below(std::size_t bound) { return ((random_() >> 32U) * bound) >> 32U; }

 private:
  std::mt19937_64 random_;
};

/// The beams begin to end - 1, and what they agree on.
struct Consensus {
  PolarLine line;
  std::size_t begin = 0;
  std::size_t end = 0;
  int inliers = 0;
};

/// Looks for the one line with the most inliers among some beams.
class Search {
 public:
  Search(const Sweep& sweep, const ScanParameters& parameters, const Run& among)
      : sweep_(sweep),
        beams_(sweep.beams),
        ransac_(parameters.ransac),
        limit_(ransac_.inlier_sigmas * ransac_.inlier_sigmas),
        rough_(limit_ * parameters.noise.surface_roughness * parameters.noise.surface_roughness),
        among_(among) {}

  /// The best of random trials.
  Consensus find(Draw& draw) const {
    Consensus best;
    double trials = ransac_.max_trials;
    for (int trial = 0; trial < trials; ++trial) {
      const auto [first, second] = draw_pair(draw);
      const PolarLine line = polar_line(moments_of(beams_, first) + moments_of(beams_, second));
      const Consensus found = consensus_of(line, first);
      if (found.inliers <= best.inliers || found.end <= second) continue;
      best = found;
      trials = std::min(trials, trials_to_trust(best));
    }
    return best;
  }

  /// As a run, which leaves its strays out.
  Run run_of(const Consensus& found) const {
    const auto next_where = [&](bool inlier, std::size_t i) {
      while (i < found.end && is_inlier(found.line, i) != inlier) ++i;
      return i;
    };
    std::size_t end = next_where(false, found.begin);
    Run run = make_run(sweep_.sums, found.begin, end);
    while (end < found.end) {
      const std::size_t begin = next_where(true, end);
      end = next_where(false, begin);
      run = joined(run, make_run(sweep_.sums, begin, end));
    }
    return run;
  }

  /// With the line fitted to all inliers, unless it then has fewer.
  Consensus refined(const Consensus& found) const {
    const PolarLine line = polar_line(run_of(found).moments);
    const Consensus again = consensus_of(line, found.begin + (found.end - found.begin) / 2);
    return again.inliers >= found.inliers ? again : found;
  }

 private:
  std::pair<std::size_t, std::size_t> draw_pair(Draw& draw) const {
    const auto apart = static_cast<std::size_t>(ransac_.min_separation);
    const auto [first, second] =
        std::minmax({draw.below(among_.size() - apart), draw.below(among_.size() - apart)});
    return {among_.begin + first, among_.begin + second + apart};
  }

  bool is_inlier(const PolarLine& line, std::size_t i) const {
    const double off = line.a * beams_.x[i] + line.b * beams_.y[i] - 1.0;
    const double rough = rough_ * (line.a * line.a + line.b * line.b);
    return (off * off - rough) * beams_.weight[i] <= limit_;
  }

  /// Walks both ways from a beam, as far as the line goes on; nothing where not even that beam
  /// lies on it.
  Consensus consensus_of(const PolarLine& line, std::size_t from) const {
    if (!is_inlier(line, from)) return {};
    Consensus found{.line = line, .begin = from, .end = from + 1, .inliers = 1};
    std::size_t strays = 0;
    for (std::size_t i = from + 1; i < among_.end && strays <= kMostStrays; ++i) {
      if (!is_inlier(line, i)) {
        ++strays;
        continue;
      }
      strays = 0;
      found.end = i + 1;
      ++found.inliers;
    }
    strays = 0;
    for (std::size_t i = from; i > among_.begin && strays <= kMostStrays; --i) {
      if (!is_inlier(line, i - 1)) {
        ++strays;
        continue;
      }
      strays = 0;
      found.begin = i - 1;
      ++found.inliers;
    }
    return found;
  }

  /// Draws of two beams after which both were in a run as large as this one at least once, with
  /// the confidence that is asked for.
  double trials_to_trust(const Consensus& found) const {
    const double share = found.inliers / static_cast<double>(among_.size());
    return std::log(1.0 - ransac_.confidence) / std::log(1.0 - share * share);
  }

  const Sweep& sweep_;
  const Beams& beams_;
  const RansacParameters& ransac_;
  double limit_;  // [-] of squared distance over variance
  double rough_;  // [m^2] of squared distance that roughness makes
  Run among_;
};

void take_out_runs(const Sweep& sweep, const Run& stretch, const ScanParameters& parameters,
                   Draw& draw, std::vector<Run>& open, std::vector<Run>& runs) {
  const auto fewest = static_cast<std::size_t>(
      std::max(parameters.ransac.min_inliers, parameters.ransac.min_separation + 1));
  open.assign(1, stretch);
  while (!open.empty()) {
    const Run among = open.back();
    open.pop_back();
    if (among.size() < fewest) continue;
    const Search search(sweep, parameters, among);
    const Consensus best = search.find(draw);
    if (best.inliers < parameters.ransac.min_inliers) continue;
    const Run run = search.run_of(search.refined(best));
    runs.push_back(run);
    open.push_back(make_run(sweep.sums, run.end, among.end));
    open.push_back(make_run(sweep.sums, among.begin, run.begin));
  }
}

}  // namespace

void ransac(const Sweep& sweep, const ScanParameters& parameters, Workspace& workspace,
            std::vector<Run>& runs) {
  Draw draw(parameters.ransac.seed);
  for (const Run& stretch : sweep.stretches)
    take_out_runs(sweep, stretch, parameters, draw, workspace.open, runs);
  std::ranges::sort(runs, {}, &Run::begin);
  merge_neighbours(runs, sweep.beams, parameters, workspace.gains);
}

}  // namespace perceptor::scan
