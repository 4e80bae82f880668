/// @file What the picture listens to.
#pragma once

#include "common/bus/bus.hpp"
#include "components/viewer/newest.hpp"

namespace perceptor::viewer {

/// `newest` takes every valid message that the bus handles from now on, whatever its stamp: what
/// began anew is for the picture to see.
void listen(Bus& bus, Newest& newest);

}  // namespace perceptor::viewer
