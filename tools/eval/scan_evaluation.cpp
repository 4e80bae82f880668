#include "tools/eval/scan_evaluation.hpp"

#include <algorithm>
#include <chrono>

#include "tools/eval/extract.hpp"
#include "tools/eval/floor.hpp"
#include "tools/eval/true_association.hpp"

namespace perceptor {
namespace {

/// Of several runs of the same work [us].
template <class Work>
double shortest_us(int repetitions, Work&& work) {
  using Clock = std::chrono::steady_clock;
  auto shortest = Clock::duration::max();
  for (int i = 0; i < repetitions; ++i) {
    const auto begin = Clock::now();
    work();
    shortest = std::min(shortest, Clock::now() - begin);
  }
  return std::chrono::duration<double, std::micro>(shortest).count();
}

ScanScore score_bound(const ScanSet& set) {
  ScanScorer scorer;
  for (const LabelledScan& scan : set.scans) scorer.take(scan, walls_by_truth(scan));
  return scorer.score();
}

ScanScore score(const ScanSet& set, const std::vector<FoundWalls>& found) {
  ScanScorer scorer;
  for (std::size_t i = 0; i < set.scans.size(); ++i) scorer.take(set.scans[i], found[i]);
  return scorer.score();
}

}  // namespace

ScanEvaluation evaluate(const ScanSet& set, const scan::ScanParameters& parameters,
                        const std::vector<NamedMethod>& methods, int repetitions,
                        const std::function<void(std::int64_t)>& progress) {
  ScanEvaluation evaluation;
  std::vector<WallFinder> finders;
  for (const NamedMethod& method : methods) {
    scan::ScanParameters with_method = parameters;
    with_method.method = method.method;
    finders.emplace_back(with_method, set.footprint);
    evaluation.methods.push_back({method.name, {}, {}, {}});
  }

  std::int64_t done = 0;
  for (const LabelledScan& labelled : set.scans) {
    const LaserScan& scan = labelled.scan;
    Floor floor(scan.bearings);
    evaluation.floor_us.push_back(shortest_us(repetitions, [&] { floor.run(scan); }));
    progress(++done);
    for (std::size_t i = 0; i < finders.size(); ++i) {
      MethodResult& result = evaluation.methods[i];
      result.times_us.push_back(shortest_us(repetitions, [&] { finders[i].run(scan); }));
      result.found.push_back(finders[i].found());
      progress(++done);
    }
  }
  if (!set.has_truth) return evaluation;
  evaluation.bound = score_bound(set);
  for (MethodResult& result : evaluation.methods) result.score = score(set, result.found);
  return evaluation;
}

}  // namespace perceptor
