/// @file The default method: split and merge, where every decision is a likelihood ratio.
///
///   1. split each stretch between gaps at the beam farthest from its chord, as the iterative
///      end-point fit does (Ramer 1972, Duda and Hart 1973), as long as two lines explain the
///      beams better than one by more than noise does (Nguyen et al., "A comparison of line
///      extraction algorithms using 2D range data for indoor mobile robotics", 2007, have the
///      plain form of it);
///   2. where the chord shows no place to split but one line does not explain the beams, try
///      others;
///   3. merge neighbours that one line explains, over strays too (merging.hpp);
///   4. give the beams of short runs that are left at corners to the walls beside them
///      (dissolving.hpp);
///   5. move each cut to where the lines of its two walls cross (cuts.hpp).
///
/// Each test costs the same few nanoseconds, however many beams: see line_fit.hpp. All decisions of
/// a step are made on the runs as they were before it, so that the result is the same whichever
/// way the laser turns, and wherever a circle begins.
#pragma once

#include <vector>

#include "components/scan/methods.hpp"

namespace perceptor::scan {

void split_and_merge(const Sweep& sweep, const ScanParameters& parameters, Workspace& workspace,
                     std::vector<Run>& runs);

}  // namespace perceptor::scan
