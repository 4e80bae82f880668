/// @file Cuts a stretch of beams where its direction turns.
///
/// Noise makes the angle between close points useless, so the beams are first resampled:
/// points at least a spacing apart, each the mean of the beams around it. Then, point by point:
///   1. the next angle is the direction from the cluster's last point to the next point;
///   2. the mean angle of the cluster, each step weighted by its length, is the direction from
///      its first point to its last;
///   3. where the two differ by more than noise explains, the cluster ends and another begins;
///   4. merge neighbours that one line explains (merging.hpp): a single stray turns the direction,
///      and in a circle the sweep may begin in the middle of a wall.
#pragma once

#include <vector>

#include "components/scan/methods.hpp"

namespace perceptor::scan {

void angle_clustering(const Sweep& sweep, const ScanParameters& parameters, Workspace& workspace,
                      std::vector<Run>& runs);

}  // namespace perceptor::scan
