/// @file How large the largest allocation was: this program's operator new keeps count.
#pragma once

#include <cstddef>

namespace perceptor {

void forget_allocations();
std::size_t largest_allocation();

}  // namespace perceptor
