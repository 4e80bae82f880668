/// @file What was found in a scan, as a map.
#pragma once

#include "common/model/map.hpp"
#include "components/scan/extractor.hpp"

namespace perceptor::scan {

/// Walls by bearing, each from its first point to its second counter-clockwise around the laser,
/// so that its free side is left. All ends are floating; `method` says where a corner was seen,
/// and ends with method `intersection` lie where two walls meet, others where the last beam that
/// supports the wall meets it. After the walls' points, the corners that no wall ends in: points
/// without parents. Weights are inverse variances [1/m^2]: of a wall across itself at its middle,
/// of a point the mean of both axes.
Map current_map(const Extraction& found, const CornerParameters& parameters);

}  // namespace perceptor::scan
