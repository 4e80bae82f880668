/// @file Makes one wall of two: the line by information (the Kalman update of two measured
/// lines), the extent by union, known ends by information as well.
#pragma once

#include "components/merge/wall.hpp"

namespace perceptor::merge {

struct FusionParameters {
  double outlier_sigmas = 3.0;     ///< a line further off counts for less, in proportion
  double min_offset_sigma = 2e-4;  ///< [m] no line is known better; larger lets old walls follow
                                   ///< new scans, and drift
  double min_angle_sigma = 2e-4;   ///< [rad] the same of its angle
  EndParameters ends;
  int overshoots = 3;        ///< sightings beyond a known end before it moves
  double max_weight = 30.0;  ///< of a wall, in sightings; larger: slower to forget
};

/// `other` merged into `kept`, whose identity stays. Both in one frame, and one wall as
/// `compare` says.
Wall fuse(const Wall& kept, const Wall& other, const FusionParameters& parameters);

}  // namespace perceptor::merge
