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

/// The beams, first to last, between which a cut may be moved.
struct Window {
  std::size_t first;
  std::size_t last;
};

Window window_around(const Run& before, const Run& after, const Beams& beams) {
  const std::size_t earliest = before.solid_from + kFewestBeams;
  const std::size_t latest = after.solid_until - kFewestBeams;
  const Vector2 here = beams.end(after.begin);
  const double reach = std::max(kWindow, kWindowSigmas * beams.sigma(after.begin));
  const auto is_close = [&](std::size_t i) {
    return (beams.end(i) - here).squaredNorm() < reach * reach;
  };
  Window window{before.end, after.begin};
  while (window.first > earliest && is_close(window.first)) --window.first;
  while (window.last < latest && is_close(window.last)) ++window.last;
  return window;
}

/// The first beam of the window on the far side of where the lines cross, if they do within it.
std::optional<std::size_t> crossing(const PolarLine& before, const PolarLine& after,
                                    const Window& window, const Beams& beams) {
  const double determinant = before.a * after.b - after.a * before.b;
  const Vector2 meeting((after.b - before.b) / determinant, (before.a - after.a) / determinant);
  const auto is_beyond = [&](std::size_t i) {
    return !(beams.x[i] * meeting.y() - beams.y[i] * meeting.x() > 0.0);
  };
  if (is_beyond(window.first) || !is_beyond(window.last)) return std::nullopt;
  std::size_t cut = window.first + 1;
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

void place_cut(Run& before, Run& after, const Sweep& sweep) {
  if (!adjoin(sweep.beams, before, after)) return;
  const bool is_too_short = before.end < before.solid_from + kFewestBeams ||
                            after.solid_until < after.begin + kFewestBeams;
  if (is_too_short) return;
  const Window window = window_around(before, after, sweep.beams);
  const Moments outside_before = before.moments - sweep.sums.of(window.first, before.end);
  const Moments outside_after = after.moments - sweep.sums.of(after.begin, window.last);
  const PolarLine line_before = polar_line(before.moments);
  const PolarLine line_after = polar_line(after.moments);
  const std::size_t cut = crossing(line_before, line_after, window, sweep.beams)
                              .value_or(best_fit(line_before, line_after, window, sweep.beams));
  before.moments = outside_before + sweep.sums.of(window.first, cut);
  after.moments = outside_after + sweep.sums.of(cut, window.last);
  if (before.solid_until == before.end) before.solid_until = cut;
  if (after.solid_from == after.begin) after.solid_from = cut;
  before.end = cut;
  after.begin = cut;
}

/// The two runs that share out the beams of the one between them.
struct Shares {
  Run before;
  Run after;
};

Run extended_to(Run run, std::size_t end, const Sweep& sweep) {
  run.moments = run.moments + sweep.sums.of(run.end, end);
  if (run.solid_until == run.end) run.solid_until = end;
  run.end = end;
  return run;
}

Run extended_back_to(Run run, std::size_t begin, const Sweep& sweep) {
  run.moments = run.moments + sweep.sums.of(begin, run.begin);
  if (run.solid_from == run.begin) run.solid_from = begin;
  run.begin = begin;
  return run;
}

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
  const Shares shares{extended_to(before, cut, sweep), extended_back_to(after, cut, sweep)};
  const auto chi_square = [&parameters](const Run& of) {
    return misfit(of.moments, parameters.noise.surface_roughness).chi_square;
  };
  const double three = chi_square(before) + chi_square(run) + chi_square(after);
  const double two = chi_square(shares.before) + chi_square(shares.after);
  if (two - three > parameters.wall.merge_chi2) return std::nullopt;
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

void place_cuts(std::vector<Run>& runs, const Sweep& sweep) {
  for (int round = 0; round < kRounds; ++round) {
    for (std::size_t i = 0; i + 1 < runs.size(); ++i) place_cut(runs[i], runs[i + 1], sweep);
    if (!sweep.beams.is_circle || runs.size() < 2) continue;
    turn(runs, sweep.beams);
    place_cut(runs[runs.size() - 2], runs.back(), sweep);
  }
}

}  // namespace perceptor::scan
