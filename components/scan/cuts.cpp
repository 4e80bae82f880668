#include "components/scan/cuts.hpp"

#include <algorithm>
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

/// By how much the beams of a run scatter more than their noise says: not all are of one wall, or
/// the wall is not straight.
double excess_of(const Moments& moments) {
  return std::max(1.0, misfit(moments, 0.0).chi_square / std::max(1.0, moments.beams - 2.0));
}

/// Where the cut between two runs belongs; none where it has to stay.
std::optional<std::size_t> best_cut(const Run& before, const Run& after, const PolarLine& line,
                                    const PolarLine& next_line, const Beams& beams) {
  if (!adjoin(beams, before, after)) return std::nullopt;
  const Window window = window_around(before, after, beams);
  const std::size_t fitting = best_fit(line, next_line, window, beams);
  const auto cut = crossing(line, next_line, window, beams);
  const double excess = std::max(excess_of(before.moments), excess_of(after.moments));
  return cut && !pass_by(line, next_line, *cut, fitting, excess, beams) ? *cut : fitting;
}

void move_cut(Run& before, Run& after, std::size_t cut, const PrefixMoments& sums) {
  before = with_end(before, cut, sums);
  after = with_begin(after, cut, sums);
}

/// All cuts at once, each by the runs as they were, so that no cut comes first.
void place_all(std::vector<Run>& runs, const Sweep& sweep, CutMemory& memory) {
  // A first run that passes the seam would, one turn later, end behind the last beam there is.
  if (sweep.beams.is_circle && runs.front().end > sweep.beams.count) turn(runs, sweep.beams);
  memory.lines.clear();
  memory.cuts.clear();
  for (const Run& run : runs) memory.lines.push_back(polar_line(run.moments));
  for (std::size_t i = 0; i + 1 < runs.size(); ++i)
    memory.cuts.push_back(
        best_cut(runs[i], runs[i + 1], memory.lines[i], memory.lines[i + 1], sweep.beams));
  std::optional<std::size_t> over_seam;
  if (sweep.beams.is_circle && runs.size() > 2)
    over_seam = best_cut(runs.back(), past_seam(runs.front(), sweep.beams), memory.lines.back(),
                         memory.lines.front(), sweep.beams);

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
    sum += std::clamp(misfit_of(beams, i, before) - misfit_of(beams, i, after), -most,
                      most);
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
  for (int round = 0; round < kRounds; ++round) place_all(runs, sweep, memory);
}

}  // namespace perceptor::scan
