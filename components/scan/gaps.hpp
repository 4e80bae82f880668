/// @file Where a wall cannot go on from one beam to the next.
#pragma once

#include <cstdint>
#include <vector>

#include "components/scan/beams.hpp"

namespace perceptor::scan {

/// Whether a wall cannot go on from beam i to the later beam j. On a wall that is hit at an
/// angle of at least `min_incidence`, neighbours are no further apart than the law of sines
/// allows (the adaptive breakpoint detector of Borges and Aldon, "Line extraction in 2D range
/// images for mobile robotics", 2004); where beams are missing, `max_hole` bounds it as well.
bool is_gap(const Beams& beams, std::size_t i, std::size_t j);

/// Finds the gaps of a scan; keeps its memory.
class Gaps {
 public:
  /// Takes the memory that scans of so many beams need at most.
  void reserve(std::size_t beams);

  /// Looks between all neighbours. Takes out beams that jump away from both their neighbours
  /// while those belong together, and says which.
  void find(Beams& beams);

  /// The beams that do not go on from the one before them, in order.
  const std::vector<std::size_t>& gaps() const { return gaps_; }
  /// Beams of the scan that were taken out.
  const std::vector<std::size_t>& strays() const { return strays_; }

 private:
  void look_at_steps(const Beams& beams);
  void list_gaps(std::size_t count);
  void find_strays(const Beams& beams);
  void take_out_strays(Beams& beams);

  std::vector<double> excess_;  // [m^2] of the squared step from the beam before over the largest
  std::vector<std::size_t> gaps_;
  std::vector<std::size_t> strays_;
};

}  // namespace perceptor::scan
