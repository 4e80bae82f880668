/// @file Incremental regression, also called line tracking: the "incremental" method of Nguyen et
/// al., "A comparison of line extraction algorithms using 2D range data for indoor mobile
/// robotics", 2007.
///
///   1. begin a run with a few beams; where one line does not explain even those, begin one beam
///      later;
///   2. take the next beam into the regression;
///   3. as long as the summed squared error, each beam's in sigmas of its own noise, rises by no
///      more than a limit, go on with 2;
///   4. otherwise leave that beam out, and begin the next run with it;
///   5. merge neighbours that one line explains (merging.hpp), since a single outlier ends a run.
///
/// A step costs the same few nanoseconds, however long the run has grown: see line_fit.hpp.
///
/// It goes one way, as published, counter-clockwise, so the result depends on the way: where a
/// corner is flat, the wall before it mostly keeps the first beams of the wall behind it.
#pragma once

#include <vector>

#include "components/scan/methods.hpp"

namespace perceptor::scan {

void incremental_regression(const Sweep& sweep, const ScanParameters& parameters,
                            Workspace& workspace, std::vector<Run>& runs);

}  // namespace perceptor::scan
