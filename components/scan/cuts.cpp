#include "components/scan/cuts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace perceptor::scan {
namespace {

/// Each line is as good as its beams, and which beams are its own depends on both lines.
constexpr int kRounds = 2;

/// [m] How far a cut moves at most; a corner's beams were cut closer than that.
constexpr double kWindow = 0.15;
/// The same in sigmas of the range: the larger of the two.
constexpr double kWindowSigmas = 18.0;

/// Squared distances, in variances, that the beams at a crossing may add up to more than at the
/// best cut.
constexpr double kDoubt = 16.0;
/// What one of them counts at most, so that no outlier decides.
constexpr double kMostDoubt = 9.0;

/// Standard deviations of chi-square over what is expected of beams of one wall.
constexpr double kMixedSigmas = 3.0;

/// How many of its solid beams a run may give away: less than half, so that it keeps enough even
/// if both its ends move.
std::size_t spare(std::size_t solid) {
  return solid > kFewestBeams ? (solid - kFewestBeams) / 2 : 0;
}

Window window_around(const Run& before, const Run& after, const Beams& beams) {
  const std::size_t earliest = before.end - spare(before.end - before.solid_from);
  const std::size_t latest = after.begin + spare(after.solid_until - after.begin);
  const Vector2 here = 0.5 * (beams.end(before.end - 1) + beams.end(after.begin));
  const double sigma = std::max(beams.sigma(before.end - 1), beams.sigma(after.begin));
  const double reach = std::max(kWindow, kWindowSigmas * sigma);
  const auto is_close = [&](std::size_t i) {
    return (beams.end(i) - here).squaredNorm() < reach * reach;
  };
  Window window{before.end, after.begin};
  while (window.first > earliest && is_close(window.first - 1)) --window.first;
  while (window.last < latest && is_close(window.last)) ++window.last;
  return window;
}

/// The cut of the window between the beams on both sides of where the lines cross, if they do
/// within it.
std::optional<std::size_t> crossing(const PolarLine& before, const PolarLine& after,
                                    const Window& window, const Beams& beams) {
  const double determinant = before.a * after.b - after.a * before.b;
  const Vector2 meeting((after.b - before.b) / determinant, (before.a - after.a) / determinant);
  const auto is_beyond = [&](std::size_t i) {
    return !(beams.x[i] * meeting.y() - beams.y[i] * meeting.x() > 0.0);
  };
  if (is_beyond(window.first - 1) || !is_beyond(window.last)) return std::nullopt;
  std::size_t cut = window.first;
  while (!is_beyond(cut)) ++cut;
  return cut;
}

/// Squared distance of a beam from a line, in variances of its range.
double misfit_of(const Beams& beams, std::size_t i, const PolarLine& line) {
  const double off = line.a * beams.x[i] + line.b * beams.y[i] - 1.0;
  return beams.weight[i] * off * off;
}

/// Squared distances of all beams from their best line, in variances of their ranges.
double chi_square_of(const Moments& m, const PolarLine& line) {
  return m.w - line.a * m.x - line.b * m.y;
}

FittedRun fitted(const Run& run) {
  const PolarLine line = polar_line(run.moments);
  const double chi_square = chi_square_of(run.moments, line);
  const double degrees_of_freedom = std::max(1.0, run.moments.beams - 2.0);
  const double scatter = kMixedSigmas * std::sqrt(2.0 * degrees_of_freedom);
  return {.line = line,
          .excess = std::max(1.0, chi_square / degrees_of_freedom),
          .is_mixed = chi_square > degrees_of_freedom + scatter};
}

/// The cut of the window that leaves the best two lines, each fitted to what it leaves.
std::size_t best_fit_anew(const Run& before, const Run& after, const Window& window,
                          const Sweep& sweep) {
  Moments left = with_end(before, window.first, sweep.sums).moments;
  Moments right = with_begin(after, window.first, sweep.sums).moments;
  std::size_t best = window.first;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t cut = window.first;; ++cut) {
    const double chi_square =
        chi_square_of(left, polar_line(left)) + chi_square_of(right, polar_line(right));
    if (chi_square < least) best = cut;
    least = std::min(least, chi_square);
    if (cut == window.last) return best;
    const Moments next = moments_of(sweep.beams, cut);
    left = left + next;
    right = right - next;
  }
}

/// Where the cut between two runs belongs; none where it has to stay. The line of a run with
/// foreign beams is theirs as well, so the first cut is not by the lines.
std::optional<std::size_t> best_cut(const Run& before, const Run& after, const FittedRun& left,
                                    const FittedRun& right, const Sweep& sweep, bool is_first) {
  const Beams& beams = sweep.beams;
  if (!adjoin(beams, before, after)) return std::nullopt;
  const Window window = window_around(before, after, beams);
  if (is_first && (left.is_mixed || right.is_mixed))
    return best_fit_anew(before, after, window, sweep);
  const std::size_t fitting = best_fit(left.line, right.line, window, beams);
  const auto cut = crossing(left.line, right.line, window, beams);
  const double excess = std::max(left.excess, right.excess);
  return cut && !pass_by(left.line, right.line, *cut, fitting, excess, beams) ? *cut : fitting;
}

void move_cut(Run& before, Run& after, std::size_t cut, const PrefixMoments& sums) {
  before = with_end(before, cut, sums);
  after = with_begin(after, cut, sums);
}

/// All cuts at once, each by the runs as they were, so that no cut comes first.
void place_all(std::vector<Run>& runs, const Sweep& sweep, CutMemory& memory, bool is_first) {
  // A first run that passes the seam would, one turn later, end behind the last beam there is.
  if (sweep.beams.is_circle && runs.front().end > sweep.beams.count) turn(runs, sweep.beams);
  std::vector<FittedRun>& fits = memory.fits;
  fits.clear();
  memory.cuts.clear();
  for (const Run& run : runs) fits.push_back(fitted(run));
  for (std::size_t i = 0; i + 1 < runs.size(); ++i)
    memory.cuts.push_back(best_cut(runs[i], runs[i + 1], fits[i], fits[i + 1], sweep, is_first));
  std::optional<std::size_t> over_seam;
  if (sweep.beams.is_circle && runs.size() > 2)
    over_seam = best_cut(runs.back(), past_seam(runs.front(), sweep.beams), fits.back(),
                         fits.front(), sweep, is_first);

  const std::size_t end_at_seam = runs.back().end;
  for (std::size_t i = 0; i + 1 < runs.size(); ++i)
    if (memory.cuts[i]) move_cut(runs[i], runs[i + 1], *memory.cuts[i], sweep.sums);
  if (!over_seam) return;
  turn(runs, sweep.beams);
  Run& before = runs[runs.size() - 2];
  // The turn may have moved all runs a turn back.
  move_cut(before, runs.back(), before.end + (*over_seam - end_at_seam), sweep.sums);
}

}  // namespace

bool pass_by(const PolarLine& before, const PolarLine& after, std::size_t crossing,
             std::size_t fitting, double excess, const Beams& beams) {
  const auto [first, last] = std::minmax(crossing, fitting);
  const double most = kMostDoubt * excess;
  double sum = 0.0;
  for (std::size_t i = first; i < last; ++i)
    sum += std::clamp(misfit_of(beams, i, before) - misfit_of(beams, i, after), -most, most);
  return (crossing > fitting ? sum : -sum) > kDoubt * excess;
}

std::size_t best_fit(const PolarLine& before, const PolarLine& after, const Window& window,
                     const Beams& beams) {
  std::size_t best = window.first;
  double least = 0.0;
  double sum = 0.0;
  for (std::size_t i = window.first; i < window.last; ++i) {
    sum += misfit_of(beams, i, before) - misfit_of(beams, i, after);
    if (sum >= least) continue;
    least = sum;
    best = i + 1;
  }
  return best;
}

void place_cuts(std::vector<Run>& runs, const Sweep& sweep, CutMemory& memory) {
  if (runs.empty()) return;
  for (int round = 0; round < kRounds; ++round) place_all(runs, sweep, memory, round == 0);
}

}  // namespace perceptor::scan
