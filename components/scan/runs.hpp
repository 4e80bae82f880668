/// @file Runs of beams that one straight wall may explain, and when two of them are one.
#pragma once

#include <cstddef>
#include <vector>

#include "components/scan/gaps.hpp"
#include "components/scan/line_fit.hpp"

namespace perceptor::scan {

/// Consecutive beams, begin to end - 1; end may pass the seam of a circle.
struct Run {
  std::size_t begin = 0;
  std::size_t end = 0;
  std::size_t solid_until = 0;  ///< the first stray that was bridged; end: none
  std::size_t solid_from = 0;   ///< after the last stray that was bridged; begin: none
  Moments moments;              ///< of its beams, without the strays

  std::size_t size() const { return end - begin; }
};

/// All of a scan that the methods work on.
struct Sweep {
  Beams beams;
  PrefixMoments sums;
  std::vector<Run> stretches;  ///< between gaps, in order
};

/// Beams that a run needs for a line and a look at how well it fits.
inline constexpr std::size_t kFewestBeams = 3;

/// Beams that are a line without any help.
inline constexpr std::size_t kLineBeams = 8;

/// Beams between two pieces of one wall, or at a corner: more than these are something else.
inline constexpr std::size_t kMostStrays = 5;

/// A run of these beams, all of them counted.
Run make_run(const PrefixMoments& sums, std::size_t begin, std::size_t end);

/// The run that ends before another beam, all beams up to there counted.
Run with_end(Run run, std::size_t end, const PrefixMoments& sums);

/// The run that begins at another beam, all beams from there counted.
Run with_begin(Run run, std::size_t begin, const PrefixMoments& sums);

/// The same run, one turn later.
Run past_seam(Run run, const Beams& beams);

/// How much better two lines explain the beams than one, less what noise, and the bend of real
/// surfaces, make of one line: negative where one line explains them [-].
double gain_of_cut(const Moments& first, const Moments& second, const ScanParameters& parameters);

/// Whether the second run begins where the first ends, without a gap.
bool adjoin(const Beams& beams, const Run& first, const Run& second);

/// Whether the second run begins where the first ends or a few strays behind, without a gap.
bool follows(const Beams& beams, const Run& first, const Run& second);

/// Whether a wall may go on from the first run to the second, over a few strays or none. Where
/// there is a gap, one of them has to be a line itself, and the gap a hole at most: without a line
/// to begin with, clutter would turn into walls that point at the laser, and over wider gaps the
/// two sides of a doorway into one wall.
bool is_bridgeable(const Beams& beams, const Run& first, const Run& second);

/// Both runs and what lies between them; that does not count.
Run joined(const Run& first, const Run& second);

/// In a circle, puts the first run behind the last: neighbours over the seam then stand next
/// to each other. The first run always begins within the first turn, so that none ends after
/// the second.
void turn(std::vector<Run>& runs, const Beams& beams);

}  // namespace perceptor::scan
