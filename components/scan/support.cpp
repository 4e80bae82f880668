#include "components/scan/support.hpp"

#include <algorithm>

#include <Eigen/Core>

namespace perceptor::scan {
namespace {

/// Fits after which the set of supporting beams has settled, or never will.
constexpr int kFits = 3;

/// Foreign beams at an end, at most.
constexpr int kTrims = 3;

/// The best line through the beams. The weight of a beam grows with its range as measured, so
/// that beams which err outwards count for more: to first order the normal equations are off by
/// three times the sum of the beams, whatever the noise, and that is put back.
PolarLine unbiased_line(const Support& support) {
  constexpr double kBias = 3.0;
  Moments moments = support.moments;
  moments.x += kBias * support.sum.x();
  moments.y += kBias * support.sum.y();
  return polar_line(moments);
}

/// By how much the beams scatter more than the noise says: not straight, or not so precise.
double excess_of(const Moments& moments, const ScanParameters& parameters) {
  const double chi_square = misfit(moments, parameters.noise.surface_roughness).chi_square;
  const double degrees_of_freedom = std::max(1.0, moments.beams - 2.0);
  return std::clamp(chi_square / degrees_of_freedom, 1.0, parameters.wall.max_excess);
}

/// The run's part of an array.
Eigen::Map<const Eigen::ArrayXd> of_run(const Run& run, const std::vector<double>& array) {
  return {array.data() + run.begin, static_cast<Eigen::Index>(run.size())};
}

/// Whether no beam of the run is further from the line than the limits allow: several beams at a
/// time, since mostly it is so.
bool all_support(const Run& run, const Beams& beams, const PolarLine& line, double limit,
                 double rough) {
  const auto x = of_run(run, beams.x);
  const auto y = of_run(run, beams.y);
  const auto weight = of_run(run, beams.weight);
  const auto off = line.a * x + line.b * y - 1.0;
  return ((off.square() - rough) * weight).maxCoeff() <= limit;
}

/// The beams of the run within some sigmas of the line, `excess` their variance over what the
/// noise says.
Support find_support(const Run& run, const Sweep& sweep, const PolarLine& line, double excess,
                     const ScanParameters& parameters) {
  const Beams& beams = sweep.beams;
  const double sigmas = parameters.wall.support_sigmas;
  const double limit = sigmas * sigmas * excess;
  const double roughness = parameters.noise.surface_roughness;
  const double rough = limit * roughness * roughness * (line.a * line.a + line.b * line.b);
  Support support{.first = run.begin,
                  .last = run.end - 1,
                  .count = static_cast<int>(run.size()),
                  .moments = sweep.sums.of(run.begin, run.end),
                  .sum = {of_run(run, beams.x).sum(), of_run(run, beams.y).sum()}};
  if (all_support(run, beams, line, limit, rough)) return support;
  support.count = 0;
  for (std::size_t i = run.begin; i < run.end; ++i) {
    const double off = line.a * beams.x[i] + line.b * beams.y[i] - 1.0;
    if ((off * off - rough) * beams.weight[i] > limit) {
      support.moments = support.moments - moments_of(beams, i);
      support.sum -= beams.end(i);
      continue;
    }
    if (support.count++ == 0) support.first = i;
    support.last = i;
  }
  return support;
}

/// Fits and drops until the beams stay the same.
SupportedLine settle(const Run& run, const Moments& moments, const Sweep& sweep,
                     const ScanParameters& parameters) {
  SupportedLine fitted{.line = polar_line(moments),
                       .support = {.moments = moments},
                       .excess = excess_of(moments, parameters)};
  int before = static_cast<int>(moments.beams);
  for (int fit = 0; fit < kFits; ++fit) {
    fitted.support = find_support(run, sweep, fitted.line, fitted.excess, parameters);
    if (fitted.support.count < parameters.wall.min_beams) return fitted;
    fitted.line = unbiased_line(fitted.support);
    fitted.excess = excess_of(fitted.support.moments, parameters);
    if (fitted.support.count == before) return fitted;
    before = fitted.support.count;
  }
  return fitted;
}

/// Whether a beam is too far from the line that the others give. A foreign beam at the end of a
/// short run draws the line towards itself, and then seems to support it (the deleted residual of
/// Cook and Weisberg, "Residuals and Influence in Regression", 1982).
bool is_loose(const Beams& beams, std::size_t i, const SupportedLine& fitted,
              const ScanParameters& parameters) {
  const Moments own = moments_of(beams, i);
  const Moments others = fitted.support.moments - own;
  const PolarLine line = polar_line(others);
  const double off = line.a * beams.x[i] + line.b * beams.y[i] - 1.0;
  const double determinant = others.xx * others.yy - others.xy * others.xy;
  const double uncertain =
      (own.xx * others.yy - 2.0 * own.xy * others.xy + own.yy * others.xx) / determinant;
  const double roughness = parameters.noise.surface_roughness;
  const double rough = roughness * roughness * (line.a * line.a + line.b * line.b) * own.w;
  const double sigmas = parameters.wall.support_sigmas;
  return off * off * own.w > sigmas * sigmas * fitted.excess * (1.0 + uncertain) * (1.0 + rough);
}

}  // namespace

SupportedLine fit_supported_line(const Run& run, const Sweep& sweep,
                                 const ScanParameters& parameters) {
  Run trimmed = run;
  SupportedLine fitted = settle(trimmed, trimmed.moments, sweep, parameters);
  for (int trim = 0; trim < kTrims; ++trim) {
    if (fitted.support.count <= parameters.wall.min_beams) break;
    const Support support = fitted.support;
    const bool drop_first = is_loose(sweep.beams, support.first, fitted, parameters);
    const bool drop_last = is_loose(sweep.beams, support.last, fitted, parameters);
    if (!drop_first && !drop_last) break;
    Moments left = support.moments;
    if (drop_first) left = left - moments_of(sweep.beams, support.first);
    if (drop_last) left = left - moments_of(sweep.beams, support.last);
    trimmed.begin = support.first + (drop_first ? 1 : 0);
    trimmed.end = support.last + (drop_last ? 0 : 1);
    fitted = settle(trimmed, left, sweep, parameters);
  }
  return fitted;
}

}  // namespace perceptor::scan
