#include "components/scan/runs.hpp"

#include <algorithm>
#include <cmath>

namespace perceptor::scan {
namespace {

/// The run some beams later; unsigned arithmetic wraps, so less than nothing is earlier.
Run shifted(Run run, std::size_t beams) {
  run.begin += beams;
  run.end += beams;
  run.solid_until += beams;
  run.solid_from += beams;
  return run;
}

/// Of a straight piece on which beams are spread evenly as these are [m].
double length_of(const Moments& m) {
  const double spread = (m.xx + m.yy - (m.x * m.x + m.y * m.y) / m.w) / m.w;
  return std::sqrt(12.0 * std::max(0.0, spread));
}

}  // namespace

Run make_run(const PrefixMoments& sums, std::size_t begin, std::size_t end) {
  return {.begin = begin,
          .end = end,
          .solid_until = end,
          .solid_from = begin,
          .moments = sums.of(begin, end)};
}

Run with_end(Run run, std::size_t end, const PrefixMoments& sums) {
  run.moments =
      end < run.end ? run.moments - sums.of(end, run.end) : run.moments + sums.of(run.end, end);
  if (run.solid_until == run.end) run.solid_until = end;
  run.end = end;
  return run;
}

Run with_begin(Run run, std::size_t begin, const PrefixMoments& sums) {
  run.moments = begin > run.begin ? run.moments - sums.of(run.begin, begin)
                                  : run.moments + sums.of(begin, run.begin);
  if (run.solid_from == run.begin) run.solid_from = begin;
  run.begin = begin;
  return run;
}

Run past_seam(Run run, const Beams& beams) { return shifted(run, beams.count); }

double gain_of_cut(const Moments& first, const Moments& second, const ScanParameters& parameters) {
  const double roughness = parameters.noise.surface_roughness;
  const Moments both = first + second;
  const Misfit together = misfit(both, roughness);
  const double apart = misfit(first, roughness).chi_square + misfit(second, roughness).chi_square;
  const double degrees_of_freedom = std::max(1.0, both.beams - 4.0);
  const double length = length_of(both);
  const double crooked = std::min(parameters.wall.bend, parameters.wall.bend_growth * length);
  const double bend = both.beams * crooked * crooked / together.variance;
  // Where even two lines fit worse than the noise says, the wall is bumpy.
  const double excess = std::clamp(apart / degrees_of_freedom, 1.0, parameters.wall.max_excess);
  return (together.chi_square - apart) / excess - parameters.wall.merge_chi2 - bend;
}

bool adjoin(const Beams& beams, const Run& first, const Run& second) {
  return second.begin == first.end && !is_gap(beams, first.end - 1, second.begin);
}

bool follows(const Beams& beams, const Run& first, const Run& second) {
  return second.begin - first.end <= kMostStrays && !is_gap(beams, first.end - 1, second.begin);
}

bool is_bridgeable(const Beams& beams, const Run& first, const Run& second) {
  if (follows(beams, first, second)) return true;
  if (second.begin - first.end > kMostStrays) return false;
  const bool one_is_a_line = std::max(first.size(), second.size()) >= kLineBeams;
  const Vector2 hole = beams.end(second.begin) - beams.end(first.end - 1);
  return one_is_a_line && hole.squaredNorm() <= beams.max_hole * beams.max_hole;
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

void turn(std::vector<Run>& runs, const Beams& beams) {
  if (!beams.is_circle || runs.size() < 2) return;
  std::ranges::rotate(runs, runs.begin() + 1);
  runs.back() = past_seam(runs.back(), beams);
  if (runs.front().begin < beams.count) return;
  for (Run& run : runs) run = shifted(run, 0 - beams.count);
}

}  // namespace perceptor::scan
