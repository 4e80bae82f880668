/// @file The iterative end-point fit: Ramer, "An iterative procedure for the polygonal
/// approximation of plane curves", 1972; Duda and Hart, "Pattern classification and scene
/// analysis", 1973.
///
///   1. draw the chord from the first beam of a stretch to the last;
///   2. find the beam farthest from it, beyond what noise explains: some sigmas of this beam's
///      and the ends' noise across the chord. The original has one distance for all;
///   3. where there is one, cut there, and go on with both parts;
///   4. merge neighbours that one line explains. The original leaves this out, and a wall stays
///      in pieces where an outlier, or the noise of a chord's end, cut it. The test is the one of
///      merging.hpp, which split_and_merge uses as well.
///
/// Whether to cut rests on three beams, however many there are: fast, and the least sure.
#pragma once

#include <vector>

#include "components/scan/methods.hpp"

namespace perceptor::scan {

void endpoint_fit(const Sweep& sweep, const ScanParameters& parameters, Workspace& workspace,
                  std::vector<Run>& runs);

}  // namespace perceptor::scan
