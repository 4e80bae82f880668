#include "components/scan/extractor.hpp"

#include <algorithm>
#include <utility>

namespace perceptor::scan {

WallExtractor::WallExtractor(const ScanParameters& parameters, std::vector<Vector2> footprint)
    : parameters_(parameters), reader_(parameters.noise, parameters.gap, std::move(footprint)) {}

const Extraction& WallExtractor::extract(const LaserScan& scan, const Twist& twist) {
  Beams& beams = sweep_.beams;
  reserve_for(scan.size());
  reader_.read(scan, twist, beams);
  gaps_.find(beams);
  if (beams.is_circle) repeat(beams);
  sweep_.sums.sum(beams);
  find_stretches();

  runs_.clear();
  method_of(parameters_.method)(sweep_, parameters_, workspace_, runs_);
  fit_walls();
  find_corners(results_, found_.walls, beams, parameters_, found_.corners);
  sort_by_bearing(scan);
  found_.no_return = beams.no_return;
  found_.in_footprint = beams.in_footprint;
  return found_;
}

/// As many beams return as there are, at most, and in a circle they stand there twice. A run has a
/// beam at least, and there is a wall and a corner for each run at most: a scan that
/// looks different from all before it needs no more memory either.
void WallExtractor::reserve_for(std::size_t beams) {
  sweep_.sums.reserve(2 * beams);
  gaps_.reserve(beams);
  sweep_.stretches.reserve(beams);
  workspace_.open.reserve(beams);
  workspace_.gains.reserve(beams);
  workspace_.cuts.fits.reserve(beams);
  workspace_.cuts.cuts.reserve(beams);
  workspace_.points.reserve(beams);
  runs_.reserve(beams);
  results_.reserve(beams);
  found_.walls.reserve(beams);
  found_.corners.reserve(beams);
}

void WallExtractor::find_stretches() {
  sweep_.stretches.clear();
  std::size_t begin = 0;
  for (const std::size_t gap : gaps_.gaps()) {
    sweep_.stretches.push_back(make_run(sweep_.sums, begin, gap));
    begin = gap;
  }
  if (begin < sweep_.beams.count)
    sweep_.stretches.push_back(make_run(sweep_.sums, begin, sweep_.beams.count));
}

void WallExtractor::fit_walls() {
  results_.clear();
  found_.walls.clear();
  Wall wall;
  for (const Run& run : runs_) {
    RunResult result{.run = run, .verdict = fit_wall(run, sweep_, parameters_, wall)};
    if (result.verdict == Verdict::wall) {
      result.wall = found_.walls.size();
      found_.walls.push_back(wall);
    }
    results_.push_back(result);
  }
}

/// They are in order already, but in a circle begin anywhere.
void WallExtractor::sort_by_bearing(const LaserScan& scan) {
  std::vector<Wall>& walls = found_.walls;
  const auto bearing = [&](const Wall& wall) {
    return scan.bearings[sweep_.beams.beam[wall.first_beam]];
  };
  const auto smallest = std::ranges::min_element(walls, {}, bearing);
  const auto ahead = static_cast<std::size_t>(smallest - walls.begin());
  if (ahead == 0) return;
  std::ranges::rotate(walls, smallest);
  const auto renumber = [&](std::size_t& wall) {
    if (wall != kNoWall) wall = (wall + walls.size() - ahead) % walls.size();
  };
  for (RunResult& result : results_) renumber(result.wall);
  for (Corner& corner : found_.corners) {
    renumber(corner.before);
    renumber(corner.after);
  }
}

}  // namespace perceptor::scan
