/// @file What an extractor may have found, made by hand.
#pragma once

#include <utility>

#include "tools/eval/scan_findings.hpp"

namespace perceptor::testing {

/// A scan of five beams that looks at the wall x = 2 and at nothing else. Beam 0 does not return,
/// beams 1 to 3 are part of the wall, beam 4 is off its line.
struct HandMade {
  HandMade() {
    labelled.id = 12;
    labelled.time = 3.5;
    labelled.scan.valid_min = 0.25;
    labelled.scan.valid_max = 60.0;
    labelled.scan.range_sigma = 0.01;
    labelled.scan.bearings = {-0.5, -0.25, 0.0, 0.25, 0.5};
    labelled.scan.ranges = {0.0, 2.06, 2.004, 2.06, 2.4};
    scan::Wall wall{};
    wall.first.location = {2.0, -0.5};
    wall.last.location = {2.0, 0.5};
    for (auto* covariance : {&wall.first.covariance, &wall.last.covariance, &wall.line_covariance})
      covariance->setZero();
    found.walls.push_back(wall);
    scan::RunAccount run;
    run.first_beam = 1;
    run.last_beam = 4;
    run.beams = 4;
    run.wall = 0;
    run.support = 3;
    run.share = 0.75;
    run.length = 1.0;
    run.angle_sigma = 0.0125;
    run.before = {scan::Limit::gap, 0.41, 0.0};
    run.after = {scan::Limit::scan_end, 0.0, 0.0};
    account.runs.push_back(run);
    account.groups = {{0, 0, scan::Fate::no_return, scan::kNoRun},
                      {1, 3, scan::Fate::supports, 0},
                      {4, 4, scan::Fate::off_line, 0}};
  }

  ScanFindings findings() const { return {labelled, found, account}; }

  LabelledScan labelled;
  scan::Extraction found;
  scan::Account account;
};

}  // namespace perceptor::testing
