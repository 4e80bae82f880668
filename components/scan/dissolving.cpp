#include "components/scan/dissolving.hpp"

#include <algorithm>
#include <limits>

#include "components/scan/cuts.hpp"

namespace perceptor::scan {
namespace {

/// [m] A longer run stands for itself.
constexpr double kShort = 0.5;
/// How much more than any other cut those of a short run have to be worth.
constexpr double kWorthKeeping = 1.5;

/// Whether a run lies between neighbours that it may belong to, and is too short to be sure.
bool may_dissolve(const Run& before, const Run& run, const Run& after, const Beams& beams) {
  const Vector2 extent = beams.end(run.end - 1) - beams.end(run.begin);
  return extent.squaredNorm() < kShort * kShort && adjoin(beams, before, run) &&
         adjoin(beams, run, after);
}

/// The two runs that share out the beams of the one between them.
struct Shares {
  Run before;
  Run after;
};

Shares shared_out(const Run& before, const Run& run, const Run& after, const Sweep& sweep) {
  const std::size_t cut = best_fit(polar_line(before.moments), polar_line(after.moments),
                                   {run.begin, run.end}, sweep.beams);
  return {with_end(before, cut, sweep.sums), with_begin(after, cut, sweep.sums)};
}

/// How much worse two lines explain the beams than three do [-].
double loss_of_dissolving(const Run& before, const Run& run, const Run& after, const Sweep& sweep,
                          const ScanParameters& parameters) {
  const auto chi_square = [&parameters](const Run& of) {
    return misfit(of.moments, parameters.noise.surface_roughness).chi_square;
  };
  const Shares shares = shared_out(before, run, after, sweep);
  return chi_square(shares.before) + chi_square(shares.after) - chi_square(before) -
         chi_square(run) - chi_square(after);
}

/// Among the runs whose shares would meet its own.
bool is_least(const std::vector<double>& losses, std::size_t i) {
  const std::size_t from = i < 2 ? 0 : i - 2;
  const std::size_t to = std::min(i + 2, losses.size() - 1);
  for (std::size_t k = from; k <= to; ++k)
    if (k != i && losses[k] <= losses[i]) return false;
  return true;
}

/// Dissolves every run that loses less than the runs beside it; whether there was one.
bool dissolve_best(std::vector<Run>& runs, const Sweep& sweep, const ScanParameters& parameters,
                   std::vector<double>& losses) {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  losses.assign(runs.size(), kNever);
  for (std::size_t i = 1; i + 1 < runs.size(); ++i)
    if (may_dissolve(runs[i - 1], runs[i], runs[i + 1], sweep.beams))
      losses[i] = loss_of_dissolving(runs[i - 1], runs[i], runs[i + 1], sweep, parameters);
  const double most = kWorthKeeping * parameters.wall.merge_chi2;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const bool dissolves = losses[i] <= most && is_least(losses, i);
    if (!dissolves) {
      runs[kept++] = runs[i];
      continue;
    }
    const Shares shares = shared_out(runs[kept - 1], runs[i], runs[i + 1], sweep);
    runs[kept - 1] = shares.before;
    runs[i + 1] = shares.after;
  }
  const bool dissolved = kept < runs.size();
  runs.resize(kept);
  return dissolved;
}

void dissolve_in_line(std::vector<Run>& runs, const Sweep& sweep, const ScanParameters& parameters,
                      std::vector<double>& losses) {
  while (dissolve_best(runs, sweep, parameters, losses)) {
  }
}

}  // namespace

void dissolve_short(std::vector<Run>& runs, const Sweep& sweep, const ScanParameters& parameters,
                    std::vector<double>& losses) {
  dissolve_in_line(runs, sweep, parameters, losses);
  if (!sweep.beams.is_circle) return;
  // Twice, so that the first and the last have neighbours on both sides too.
  turn(runs, sweep.beams);
  turn(runs, sweep.beams);
  dissolve_in_line(runs, sweep, parameters, losses);
}

}  // namespace perceptor::scan
