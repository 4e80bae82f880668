/// @file How many allocations there were, and how large the largest was: the operator new of a
/// program that links this keeps count. It does not see malloc, nor what needs more alignment
/// than malloc gives.
#pragma once

#include <cstddef>

namespace perceptor::test {

void forget_allocations();
/// Since they were last forgotten.
std::size_t allocations();
/// [bytes] Since they were last forgotten.
std::size_t largest_allocation();

}  // namespace perceptor::test
