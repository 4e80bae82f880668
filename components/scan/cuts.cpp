#include "components/scan/cuts.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace perceptor::scan {
namespace {

/// Each line is as good as its beams, and which beams are its own depends on both lines.
constexpr int kRounds = 2;

/// [m] How far a cut moves at most; a corner's beams were cut closer than that.
constexpr double kWindow = 0.15;
/// The same in sigmas of the range: the larger of the two.
constexpr double kWindowSigmas = 18.0;

/// [m] A longer run stands for itself.
constexpr double kShort = 0.5;
/// How much more than any other cut those of a short run have to be worth.
constexpr double kWorthKeeping = 1.5;

/// The beams, first to last, between which a cut may be moved.
struct Window {
  std::size_t first;
  std::size_t last;
};

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

/// The cut with the least squared distances of the beams from their lines.
std::size_t best_fit(const PolarLine& before, const PolarLine& after, const Window& window,
                     const Beams& beams) {
  const auto squared = [&beams](const PolarLine& line, std::size_t i) {
    const double off = line.a * beams.x[i] + line.b * beams.y[i] - 1.0;
    return beams.weight[i] * off * off;
  };
  std::size_t best = window.first;
  double least = 0.0;
  double sum = 0.0;
  for (std::size_t i = window.first; i < window.last; ++i) {
    sum += squared(before, i) - squared(after, i);
    if (sum >= least) continue;
    least = sum;
    best = i + 1;
  }
  return best;
}

/// The run that ends before another beam, all beams up to there counted.
Run with_end(Run run, std::size_t end, const PrefixMoments& sums) {
  run.moments =
      end < run.end ? run.moments - sums.of(end, run.end) : run.moments + sums.of(run.end, end);
  if (run.solid_until == run.end) run.solid_until = end;
  run.end = end;
  return run;
}

/// The run that begins at another beam, all beams from there counted.
Run with_begin(Run run, std::size_t begin, const PrefixMoments& sums) {
  run.moments = begin > run.begin ? run.moments - sums.of(run.begin, begin)
                                  : run.moments + sums.of(begin, run.begin);
  if (run.solid_from == run.begin) run.solid_from = begin;
  run.begin = begin;
  return run;
}

/// Where the cut between two runs belongs; none where it has to stay.
std::optional<std::size_t> best_cut(const Run& before, const Run& after, const PolarLine& line,
                                    const PolarLine& next_line, const Beams& beams) {
  if (!adjoin(beams, before, after)) return std::nullopt;
  const Window window = window_around(before, after, beams);
  if (const auto cut = crossing(line, next_line, window, beams)) return cut;
  return best_fit(line, next_line, window, beams);
}

void move_cut(Run& before, Run& after, std::size_t cut, const PrefixMoments& sums) {
  before = with_end(before, cut, sums);
  after = with_begin(after, cut, sums);
}

/// All cuts at once, each by the runs as they were, so that no cut comes first.
void place_in_line(std::vector<Run>& runs, const Sweep& sweep, CutMemory& memory) {
  memory.lines.clear();
  memory.cuts.clear();
  for (const Run& run : runs) memory.lines.push_back(polar_line(run.moments));
  for (std::size_t i = 0; i + 1 < runs.size(); ++i)
    memory.cuts.push_back(
        best_cut(runs[i], runs[i + 1], memory.lines[i], memory.lines[i + 1], sweep.beams));
  for (std::size_t i = 0; i + 1 < runs.size(); ++i)
    if (memory.cuts[i]) move_cut(runs[i], runs[i + 1], *memory.cuts[i], sweep.sums);
}

/// The two runs that share out the beams of the one between them.
struct Shares {
  Run before;
  Run after;
};

/// Whether a run lies between neighbours that it may belong to, and is too short to be sure.
bool may_dissolve(const Run& before, const Run& run, const Run& after, const Beams& beams) {
  const Vector2 extent = beams.end(run.end - 1) - beams.end(run.begin);
  return extent.squaredNorm() < kShort * kShort && adjoin(beams, before, run) &&
         adjoin(beams, run, after);
}

std::optional<Shares> dissolved(const Run& before, const Run& run, const Run& after,
                                const Sweep& sweep, const ScanParameters& parameters) {
  if (!may_dissolve(before, run, after, sweep.beams)) return std::nullopt;
  const std::size_t cut = best_fit(polar_line(before.moments), polar_line(after.moments),
                                   {run.begin, run.end}, sweep.beams);
  const Shares shares{with_end(before, cut, sweep.sums), with_begin(after, cut, sweep.sums)};
  const auto chi_square = [&parameters](const Run& of) {
    return misfit(of.moments, parameters.noise.surface_roughness).chi_square;
  };
  const double three = chi_square(before) + chi_square(run) + chi_square(after);
  const double two = chi_square(shares.before) + chi_square(shares.after);
  if (two - three > kWorthKeeping * parameters.wall.merge_chi2) return std::nullopt;
  return shares;
}

void dissolve_in_line(std::vector<Run>& runs, const Sweep& sweep,
                      const ScanParameters& parameters) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const bool is_between = kept > 0 && i + 1 < runs.size();
    const std::optional<Shares> shares =
        is_between ? dissolved(runs[kept - 1], runs[i], runs[i + 1], sweep, parameters)
                   : std::nullopt;
    if (!shares) {
      runs[kept++] = runs[i];
      continue;
    }
    runs[kept - 1] = shares->before;
    runs[i + 1] = shares->after;
  }
  runs.resize(kept);
}

}  // namespace

void dissolve_short(std::vector<Run>& runs, const Sweep& sweep, const ScanParameters& parameters) {
  dissolve_in_line(runs, sweep, parameters);
  if (!sweep.beams.is_circle) return;
  turn(runs, sweep.beams);
  turn(runs, sweep.beams);
  dissolve_in_line(runs, sweep, parameters);
}

void place_cuts(std::vector<Run>& runs, const Sweep& sweep, CutMemory& memory) {
  for (int round = 0; round < kRounds; ++round) place_in_line(runs, sweep, memory);
  if (!sweep.beams.is_circle || runs.size() < 2) return;
  turn(runs, sweep.beams);
  Run& before = runs[runs.size() - 2];
  Run& after = runs.back();
  for (int round = 0; round < kRounds; ++round)
    if (const auto cut = best_cut(before, after, polar_line(before.moments),
                                  polar_line(after.moments), sweep.beams))
      move_cut(before, after, *cut, sweep.sums);
}

}  // namespace perceptor::scan
