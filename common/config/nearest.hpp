/// @file Which known word a mistyped one most likely stands for.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace perceptor::config {

/// Number of inserted, deleted, replaced or swapped neighbouring letters between two words:
/// the optimal string alignment distance (Damerau 1964, Boytsov 2011).
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The known word with the least edit distance, the first of equals; empty where none is known.
std::string nearest(std::string_view word, const std::vector<std::string>& known);

}  // namespace perceptor::config
