#include "components/scan/incremental_regression.hpp"

#include "components/scan/merging.hpp"

namespace perceptor::scan {
namespace {

/// Grows runs in one stretch.
class Grower {
 public:
  Grower(const Sweep& sweep, const ScanParameters& parameters)
      : sums_(sweep.sums),
        roughness_(parameters.noise.surface_roughness),
        limit_(parameters.incremental_regression.grow_sigmas *
               parameters.incremental_regression.grow_sigmas),
        seed_(static_cast<std::size_t>(parameters.incremental_regression.seed_beams)) {}

  void grow_all(const Run& stretch, std::vector<Run>& runs) const {
    for (std::size_t begin = stretch.begin; begin + seed_ <= stretch.end;) {
      if (error(begin, begin + seed_) > limit_) {
        ++begin;
        continue;
      }
      const std::size_t end = grown(begin, stretch.end);
      runs.push_back(make_run(sums_, begin, end));
      begin = end;
    }
  }

 private:
  /// Summed squared error of the regression of the beams begin to end - 1 [-].
  double error(std::size_t begin, std::size_t end) const {
    return misfit(sums_.of(begin, end), roughness_).chi_square;
  }

  /// Where the run ends that begins here.
  std::size_t grown(std::size_t begin, std::size_t stretch_end) const {
    std::size_t end = begin + seed_;
    double present = error(begin, end);
    while (end < stretch_end) {
      const double next = error(begin, end + 1);
      if (next - present > limit_) break;
      present = next;
      ++end;
    }
    return end;
  }

  const PrefixMoments& sums_;
  double roughness_;  // [m]
  double limit_;      // [-] of the rise of the error
  std::size_t seed_;  // beams
};

}  // namespace

void incremental_regression(const Sweep& sweep, const ScanParameters& parameters,
                            Workspace& workspace, std::vector<Run>& runs) {
  const Grower grower(sweep, parameters);
  for (const Run& stretch : sweep.stretches) grower.grow_all(stretch, runs);
  merge_over_strays(runs, sweep.beams, parameters, workspace.gains);
}

}  // namespace perceptor::scan
