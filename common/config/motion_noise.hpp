/// @file Configuration of how much a measured motion errs.
#pragma once

#include "common/config/fields.hpp"
#include "common/geometry/pose_estimate.hpp"

namespace perceptor {

void describe(config::Fields& fields, MotionNoise& noise);

}  // namespace perceptor
