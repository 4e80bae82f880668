/// @file The extractor of the scan component, as the evaluation runs it: the only place that
/// knows its interface.
#pragma once

#include <utility>
#include <vector>

#include "common/model/laser_scan.hpp"
#include "components/scan/extractor.hpp"
#include "tools/eval/found_walls.hpp"

namespace perceptor {

class WallFinder {
 public:
  /// `footprint` of the robot that carries the laser; empty: none.
  explicit WallFinder(const scan::ScanParameters& parameters, std::vector<Vector2> footprint = {})
      : extractor_(parameters, std::move(footprint)) {}

  /// From ranges to walls and corners, of a laser that stands still. This is what is timed.
  void run(const LaserScan& scan);

  /// What the last run found. Only corners where two walls meet: the truth's corners are those
  /// of which both sides are seen.
  FoundWalls found() const;

 private:
  scan::WallExtractor extractor_;
};

}  // namespace perceptor
