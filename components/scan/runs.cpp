#include "components/scan/runs.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "components/scan/angle_clustering.hpp"

namespace perceptor::scan {
namespace {

/// Beams that a run needs for a line and a look at how well it fits.
constexpr std::size_t kFewestBeams = 3;

/// Places at which a bent run is first tried; the best is then refined.
constexpr std::size_t kTrials = 32;

/// How far around the first cut the best one is looked for, in spacings of resampled points.
constexpr double kWindowSpacings = 3.0;

/// Beams between two pieces of one wall, or at a corner: more than these are something else.
constexpr std::size_t kMostStrays = 5;

/// The run some beams later; unsigned arithmetic wraps, so less than nothing is earlier.
Run shifted(Run run, std::size_t beams) {
  run.begin += beams;
  run.end += beams;
  run.solid_until += beams;
  run.solid_from += beams;
  return run;
}

double cost(const Moments& first, const Moments& second, const NoiseParameters& noise) {
  return misfit(first, noise).chi_square + misfit(second, noise).chi_square;
}

/// The cut from `from` to `to`, `step` apart, with the least cost.
template <class CostOfCut>
std::size_t best_cut(std::size_t from, std::size_t to, std::size_t step, CostOfCut cost_of_cut) {
  std::size_t best = from;
  double least = std::numeric_limits<double>::max();
  for (std::size_t cut = from; cut <= to; cut += step) {
    const double cost = cost_of_cut(cut);
    if (cost < least) {
      least = cost;
      best = cut;
    }
  }
  return best;
}

/// Where two lines explain the run better than one, if they do.
std::optional<std::size_t> find_bend(const Run& run, const PrefixMoments& sums,
                                     const ScanParameters& parameters) {
  if (run.size() < 2 * kFewestBeams) return std::nullopt;
  const std::size_t from = run.begin + kFewestBeams;
  const std::size_t to = run.end - kFewestBeams;
  const std::size_t step = 1 + (to - from) / kTrials;
  const auto cost_of_cut = [&](std::size_t cut) {
    return cost(sums.of(run.begin, cut), sums.of(cut, run.end), parameters.noise);
  };
  const std::size_t rough = best_cut(from, to, step, cost_of_cut);
  const std::size_t exact = best_cut(std::max(from, rough - std::min(rough, step)),
                                     std::min(to, rough + step), 1, cost_of_cut);
  if (one_line_explains(sums.of(run.begin, exact), sums.of(exact, run.end), parameters))
    return std::nullopt;
  return exact;
}

std::vector<Run> split_where_bent(const std::vector<Run>& runs, const PrefixMoments& sums,
                                  const ScanParameters& parameters) {
  std::vector<Run> straight;
  std::vector<Run> open(runs.rbegin(), runs.rend());
  while (!open.empty()) {
    const Run run = open.back();
    open.pop_back();
    const std::optional<std::size_t> bend = find_bend(run, sums, parameters);
    if (!bend) {
      straight.push_back(run);
      continue;
    }
    open.push_back(make_run(sums, *bend, run.end));
    open.push_back(make_run(sums, run.begin, *bend));
  }
  return straight;
}

/// In a circle, puts the first run behind the last: neighbours over the seam then stand next
/// to each other. The first run always begins within the first turn, so that none ends after
/// the second.
void turn(std::vector<Run>& runs, const Beams& beams) {
  if (!beams.is_circle || runs.size() < 2) return;
  std::ranges::rotate(runs, runs.begin() + 1);
  runs.back() = past_seam(runs.back(), beams);
  if (runs.front().begin < beams.count) return;
  for (Run& run : runs) run = shifted(run, 0 - beams.count);
}

/// Does something to all neighbours, over the seam of a circle too.
template <class Pass>
void for_all_neighbours(std::vector<Run>& runs, const Beams& beams, Pass pass) {
  pass();
  if (!beams.is_circle) return;
  turn(runs, beams);
  pass();
}

/// The first beam, going back from `from` but not past `limit`, further than `distance` from
/// the location.
std::size_t back_by(const Beams& beams, std::size_t from, std::size_t limit,
                    const Vector2& location, double distance) {
  while (from > limit && (beams[from].location - location).norm() < distance) --from;
  return from;
}

std::size_t forward_by(const Beams& beams, std::size_t from, std::size_t limit,
                       const Vector2& location, double distance) {
  while (from < limit && (beams[from].location - location).norm() < distance) ++from;
  return from;
}

/// Moves the cut between two runs that adjoin to where two lines fit best.
void place_cut(Run& first, Run& second, const Beams& beams, const PrefixMoments& sums,
               const ScanParameters& parameters) {
  const bool too_short = first.end < first.solid_from + kFewestBeams ||
                         second.solid_until < second.begin + kFewestBeams;
  if (too_short) return;
  const Vector2 corner = beams[second.begin].location;
  const double window = kWindowSpacings * spacing(beams[second.begin], parameters.cluster);
  const std::size_t earliest = first.solid_from + kFewestBeams;
  const std::size_t latest = second.solid_until - kFewestBeams;
  const std::size_t from = back_by(beams, first.end, earliest, corner, window);
  const std::size_t to = forward_by(beams, second.begin, latest, corner, window);
  const Moments up_to_cut = first.moments - sums.of(from, first.end);
  const Moments from_cut = second.moments - sums.of(second.begin, to);
  const std::size_t cut = best_cut(from, to, 1, [&](std::size_t at) {
    return cost(up_to_cut + sums.of(from, at), from_cut + sums.of(at, to), parameters.noise);
  });
  first.moments = up_to_cut + sums.of(from, cut);
  second.moments = from_cut + sums.of(cut, to);
  if (first.solid_until == first.end) first.solid_until = cut;
  if (second.solid_from == second.begin) second.solid_from = cut;
  first.end = cut;
  second.begin = cut;
}

void place_cuts(std::vector<Run>& runs, const Beams& beams, const PrefixMoments& sums,
                const ScanParameters& parameters) {
  for_all_neighbours(runs, beams, [&] {
    for (std::size_t i = 0; i + 1 < runs.size(); ++i)
      if (adjoin(beams, runs[i], runs[i + 1]))
        place_cut(runs[i], runs[i + 1], beams, sums, parameters);
  });
}

void remove_strays(std::vector<Run>& runs) {
  std::erase_if(runs, [](const Run& run) { return run.size() <= kMostStrays; });
}

/// Whether what lies between two runs is small enough to be bridged.
bool is_bridgeable(const Beams& beams, const Run& first, const Run& second) {
  const std::size_t last = first.end - 1;
  const std::size_t strays = second.begin - first.end;
  const double hole = distance(beams[last].location, beams[second.begin].location);
  return strays <= kMostStrays && (hole <= beams.max_hole || !is_gap(beams, last, second.begin));
}

bool is_one_wall(const Beams& beams, const Run& first, const Run& second,
                 const ScanParameters& parameters) {
  return is_bridgeable(beams, first, second) &&
         one_line_explains(first.moments, second.moments, parameters);
}

Run joined(const Run& first, const Run& second) {
  const bool bridges = second.begin > first.end;
  const bool first_is_solid = first.solid_until == first.end && !bridges;
  const bool second_is_solid = second.solid_from == second.begin && !bridges;
  return {.begin = first.begin,
          .end = second.end,
          .solid_until = first_is_solid ? second.solid_until : first.solid_until,
          .solid_from = second_is_solid ? first.solid_from : second.solid_from,
          .moments = first.moments + second.moments};
}

void merge_neighbours(std::vector<Run>& runs, const Beams& beams,
                      const ScanParameters& parameters) {
  for_all_neighbours(runs, beams, [&] {
    std::vector<Run> merged;
    for (const Run& run : runs) {
      merged.push_back(run);
      while (merged.size() >= 2 &&
             is_one_wall(beams, merged[merged.size() - 2], merged.back(), parameters)) {
        const Run last = merged.back();
        merged.pop_back();
        merged.back() = joined(merged.back(), last);
      }
    }
    runs = std::move(merged);
  });
}

}  // namespace

Run make_run(const PrefixMoments& sums, std::size_t begin, std::size_t end) {
  return {.begin = begin,
          .end = end,
          .solid_until = end,
          .solid_from = begin,
          .moments = sums.of(begin, end)};
}

Run past_seam(Run run, const Beams& beams) { return shifted(run, beams.count); }

std::vector<Run> split_at_gaps(const Beams& beams, const PrefixMoments& sums) {
  std::vector<Run> stretches;
  std::size_t begin = 0;
  for (std::size_t i = 1; i <= beams.count; ++i) {
    if (i < beams.count && !is_gap(beams, i - 1, i)) continue;
    stretches.push_back(make_run(sums, begin, i));
    begin = i;
  }
  return stretches;
}

bool one_line_explains(const Moments& first, const Moments& second,
                       const ScanParameters& parameters) {
  const Moments both = first + second;
  const Misfit together = misfit(both, parameters.noise);
  const double apart = cost(first, second, parameters.noise);
  const double degrees_of_freedom = std::max(1.0, both.beams - 4.0);
  const double bend = both.beams * parameters.wall.bend * parameters.wall.bend / together.variance;
  // Where even two lines fit worse than the noise says, the wall is bumpy.
  const double excess = std::clamp(apart / degrees_of_freedom, 1.0, parameters.wall.max_excess);
  return (together.chi_square - apart) / excess < parameters.wall.merge_chi2 + bend;
}

bool adjoin(const Beams& beams, const Run& first, const Run& second) {
  return second.begin - first.end <= kMostStrays && !is_gap(beams, first.end - 1, second.begin);
}

std::vector<Run> refine(std::vector<Run> runs, const Beams& beams, const PrefixMoments& sums,
                        const ScanParameters& parameters) {
  place_cuts(runs, beams, sums, parameters);
  runs = split_where_bent(runs, sums, parameters);
  merge_neighbours(runs, beams, parameters);
  remove_strays(runs);
  merge_neighbours(runs, beams, parameters);
  place_cuts(runs, beams, sums, parameters);
  return runs;
}

}  // namespace perceptor::scan
