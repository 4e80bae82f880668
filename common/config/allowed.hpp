/// @file What a key may hold, in words: for errors and for --help alike.
#pragma once

#include <string>
#include <vector>

#include "common/config/fields.hpp"

namespace perceptor::config {

std::string allowed_number(Range range);                          ///< "a number from 0 to 10"
std::string allowed_integer(IntegerRange range);                  ///< "a whole number from 1 to 8"
std::string allowed_word(const std::vector<std::string>& words);  ///< "one of \"a\", \"b\""

}  // namespace perceptor::config
