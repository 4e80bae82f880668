/// @file Random sample consensus: Fischler and Bolles, "Random sample consensus: a paradigm for
/// model fitting with applications to image analysis and automated cartography", 1981.
///
///   1. draw two beams of a stretch at random, some beams apart: the model is the line through
///      them;
///   2. its consensus is the run through these two of beams within some sigmas of the line, each
///      by its own noise; a few strays in it are bridged. The original counts all inliers
///      wherever they lie: beams that are not neighbours are no wall;
///   3. repeat, and keep the model with the most inliers, until it is unlikely that a better one
///      was missed, or the trials are used up;
///   4. fit the line to all its inliers, and look for its consensus once more;
///   5. take that run out, and go on in what remains on both sides of it, until there are too few
///      beams or no model has enough inliers;
///   6. merge neighbours that one line explains (merging.hpp), since a model through two noisy
///      beams may not reach a wall's ends.
///
/// The random numbers begin anew with each scan, and are drawn the same way everywhere: a scan's
/// result depends on that scan alone.
#pragma once

#include <vector>

#include "components/scan/methods.hpp"

namespace perceptor::scan {

void ransac(const Sweep& sweep, const ScanParameters& parameters, Workspace& workspace,
            std::vector<Run>& runs);

}  // namespace perceptor::scan
