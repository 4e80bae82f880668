/// @file Checks what must hold between values, once all of them are read.
#pragma once

#include <string>

#include "common/config/fields.hpp"

namespace perceptor::config {

/// Throws Error for the first `require` of `describe`, groups and lists included, that does
/// not hold. `source` is what the error names.
void check(const std::string& source, const Describe& describe);

}  // namespace perceptor::config
