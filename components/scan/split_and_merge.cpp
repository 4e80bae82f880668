#include "components/scan/split_and_merge.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "components/scan/cuts.hpp"
#include "components/scan/dissolving.hpp"
#include "components/scan/merging.hpp"
#include "components/scan/splitting.hpp"

namespace perceptor::scan {
namespace {

/// Steps between the places at which a run is tried that one line does not explain, though its
/// chord shows no place to split. Odd: no place in the middle, which rounding would shift.
constexpr std::size_t kTrials = 15;

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
    Cut cut = try_chord();
    if (cut.gain <= 0.0 && left_over >= parameters_.wall.merge_chi2) cut = refined(try_grid());
    if (cut.gain <= 0.0) return std::nullopt;
    return cut.at;
  }

 private:
  struct Cut {
    std::size_t at;
    double gain;
  };

  double chi_square_of_one_line() const {
    return misfit(sweep_.sums.of(begin_, end_), parameters_.noise.surface_roughness).chi_square;
  }

  Cut cut_at(std::size_t at) const {
    return {at, gain_of_cut(sweep_.sums.of(begin_, at), sweep_.sums.of(at, end_), parameters_)};
  }

  static Cut better(const Cut& cut, const Cut& other) {
    return other.gain > cut.gain ? other : cut;
  }

  /// The farthest beam may be the last before the corner or the first behind it.
  Cut try_chord() const {
    const std::size_t farthest = farthest_from_chord(sweep_.beams, begin_, end_);
    return better(cut_at(std::clamp(farthest, first_, last_)),
                  cut_at(std::clamp(farthest + 1, first_, last_)));
  }

  /// At equal distances, counted from the nearer end, so that they are the same from both sides.
  Cut try_grid() const {
    const std::size_t span = last_ - first_;
    Cut best = cut_at(first_);
    for (std::size_t trial = 1; trial <= kTrials; ++trial) {
      const bool is_past_middle = 2 * trial > kTrials;
      const std::size_t ahead = span * (is_past_middle ? kTrials - trial : trial) / kTrials;
      best = better(best, cut_at(is_past_middle ? last_ - ahead : first_ + ahead));
    }
    return best;
  }

  /// Halves the step of the grid until it is a single beam.
  Cut refined(Cut cut) const {
    for (std::size_t step = (last_ - first_) / kTrials; step > 0; step /= 2) {
      const std::size_t earlier = cut.at - std::min(cut.at - first_, step);
      const std::size_t later = std::min(last_, cut.at + step);
      cut = better(better(cut, cut_at(earlier)), cut_at(later));
    }
    return cut;
  }

  const Sweep& sweep_;
  const ScanParameters& parameters_;
  std::size_t begin_;
  std::size_t end_;
  std::size_t first_;  ///< the first beam that may begin the second part
  std::size_t last_;   ///< the last beam that may
};

}  // namespace

void split_and_merge(const Sweep& sweep, const ScanParameters& parameters, Workspace& workspace,
                     std::vector<Run>& runs) {
  const auto find_cut = [&](const Run& run) {
    return Splitter(sweep, parameters, run.begin, run.end).find();
  };
  split(sweep, find_cut, workspace.open, runs);
  merge_over_strays(runs, sweep.beams, parameters, workspace.gains);
  dissolve_short(runs, sweep, parameters, workspace.gains);
  place_cuts(runs, sweep, workspace.cuts);
}

}  // namespace perceptor::scan
