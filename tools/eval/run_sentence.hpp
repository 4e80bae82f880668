/// @file A run of beams in words: what limits it, and what it was judged by.
#pragma once

#include <string>

#include "components/scan/explain.hpp"

namespace perceptor {

/// "gap.max_hole 0.3": a configuration key, and what it stands at.
std::string setting(const char* key, double value);

/// "a gap of 0.41 m", "a corner of 87 deg".
std::string in_words(const scan::RunEnd& end);

/// "wall 3: 32 beams support it ..." or "too few beams support a line: 5 of at least 6
/// (wall.min_beams)": each value beside its limit, with the limit's key.
std::string verdict_in_words(const scan::RunAccount& run, const scan::ScanParameters& parameters);

/// The same without limits where it is a wall: for a table of many runs.
std::string verdict_in_short(const scan::RunAccount& run, const scan::ScanParameters& parameters);

/// Which keys say where a run ends that ends like this one; empty where none does.
std::string keys_of_ends(const scan::RunAccount& run, const scan::ScanParameters& parameters);

}  // namespace perceptor
