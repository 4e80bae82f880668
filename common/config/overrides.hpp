/// @file Sets one value from the command line: --set key=value.
#pragma once

#include <string>

#include "common/config/fields.hpp"

namespace perceptor::config {

/// `assignment` is "key=value"; the key is a path into groups and list elements, joined by
/// dots ("robot.limits.speed=0.7", "tour.0.x=1"). The value is JSON; what is no JSON is text.
/// A whole group or list may be set too: keys that a group's value leaves out keep their
/// values, a list is replaced. Throws Error, which begins "--set key=value".
void apply_override(const std::string& assignment, const Describe& describe);

}  // namespace perceptor::config
