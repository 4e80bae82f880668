#include "components/scan/split_and_merge.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "components/scan/cuts.hpp"
#include "components/scan/merging.hpp"

namespace perceptor::scan {
namespace {

/// Places at which a run is tried that one line does not explain, though its chord shows no
/// place to split.
constexpr std::size_t kTrials = 16;

/// The beam farthest from the line through the first and the last. Beams are compared several at
/// a time: the farthest of each block, then the one in the best block.
std::size_t farthest_from_chord(const Beams& beams, std::size_t begin, std::size_t end) {
  constexpr std::size_t kBlock = 32;
  const double x0 = beams.x[begin];
  const double y0 = beams.y[begin];
  const double chord_x = beams.x[end - 1] - x0;
  const double chord_y = beams.y[end - 1] - y0;
  const auto off = [&](std::size_t from, std::size_t to) {
    const auto size = static_cast<Eigen::Index>(to - from);
    const Eigen::Map<const Eigen::ArrayXd> x(beams.x.data() + from, size);
    const Eigen::Map<const Eigen::ArrayXd> y(beams.y.data() + from, size);
    return Eigen::abs(chord_x * (y - y0) - chord_y * (x - x0));
  };
  double largest = -1.0;
  std::size_t best = begin;
  for (std::size_t block = begin; block < end; block += kBlock) {
    const double here = off(block, std::min(block + kBlock, end)).maxCoeff();
    if (here <= largest) continue;
    largest = here;
    best = block;
  }
  Eigen::Index farthest = 0;
  off(best, std::min(best + kBlock, end)).maxCoeff(&farthest);
  return best + static_cast<std::size_t>(farthest);
}

/// Decides where one run is split, if it is.
class Splitter {
 public:
  Splitter(const Sweep& sweep, const ScanParameters& parameters, std::size_t begin, std::size_t end)
      : sweep_(sweep),
        parameters_(parameters),
        begin_(begin),
        end_(end),
        first_(begin + kFewestBeams),
        last_(end - kFewestBeams) {}

  std::optional<std::size_t> find() const {
    if (end_ - begin_ < 2 * kFewestBeams) return std::nullopt;
    // What one line leaves over what noise does is all that two lines can gain.
    const double left_over = chi_square_of_one_line() - static_cast<double>(end_ - begin_);
    if (left_over < 0.0) return std::nullopt;
    const std::size_t at_chord =
        std::clamp(farthest_from_chord(sweep_.beams, begin_, end_), first_, last_);
    if (gain(at_chord) > 0.0) return at_chord;
    if (left_over < parameters_.wall.merge_chi2) return std::nullopt;
    const std::size_t best = refined(best_of_trials());
    if (gain(best) > 0.0) return best;
    return std::nullopt;
  }

 private:
  double gain(std::size_t cut) const {
    return gain_of_cut(sweep_.sums.of(begin_, cut), sweep_.sums.of(cut, end_), parameters_);
  }

  double chi_square_of_one_line() const {
    return misfit(sweep_.sums.of(begin_, end_), parameters_.noise.surface_roughness).chi_square;
  }

  std::size_t best_of_trials() const {
    const std::size_t step = 1 + (last_ - first_) / kTrials;
    return best_from(first_, last_, step);
  }

  /// Halves the step until it is a single beam.
  std::size_t refined(std::size_t cut) const {
    for (std::size_t step = (1 + (last_ - first_) / kTrials) / 2; step > 0; step /= 2)
      cut =
          best_from(std::max(first_, cut - std::min(cut, step)), std::min(last_, cut + step), step);
    return cut;
  }

  std::size_t best_from(std::size_t from, std::size_t to, std::size_t step) const {
    std::size_t best = from;
    double most = -std::numeric_limits<double>::infinity();
    for (std::size_t cut = from; cut <= to; cut += step) {
      const double here = gain(cut);
      if (here <= most) continue;
      most = here;
      best = cut;
    }
    return best;
  }

  const Sweep& sweep_;
  const ScanParameters& parameters_;
  std::size_t begin_;
  std::size_t end_;
  std::size_t first_;  ///< the first beam that may begin the second part
  std::size_t last_;   ///< the last beam that may
};

void split(const Sweep& sweep, const Run& stretch, const ScanParameters& parameters,
           std::vector<Run>& open, std::vector<Run>& runs) {
  open.assign(1, stretch);
  while (!open.empty()) {
    const Run run = open.back();
    open.pop_back();
    const auto cut = Splitter(sweep, parameters, run.begin, run.end).find();
    if (!cut) {
      runs.push_back(run);
      continue;
    }
    open.push_back(make_run(sweep.sums, *cut, run.end));
    open.push_back(make_run(sweep.sums, run.begin, *cut));
  }
}

}  // namespace

void split_and_merge(const Sweep& sweep, const ScanParameters& parameters, Workspace& workspace,
                     std::vector<Run>& runs) {
  for (const Run& stretch : sweep.stretches)
    split(sweep, stretch, parameters, workspace.open, runs);
  merge_neighbours(runs, sweep.beams, parameters, workspace.gains);
  remove_small(runs);
  merge_neighbours(runs, sweep.beams, parameters, workspace.gains);
  dissolve_short(runs, sweep, parameters);
  place_cuts(runs, sweep);
}

}  // namespace perceptor::scan
