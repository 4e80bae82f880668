/// @file All openings that the walls of a map could bound, before any is chosen.
#pragma once

#include <array>
#include <vector>

#include "components/identify/openings.hpp"

namespace perceptor::identify {

struct Candidate {
  Opening opening;
  double width = 0.0;             ///< [m]
  std::array<Index, 4> points{};  ///< the ends that bound it, with their partners; or kNone
};

/// Steps 1 to 3 of openings.hpp, the choice left out. In no particular order.
std::vector<Candidate> find_candidates(const Map& map, const std::vector<Wall>& walls,
                                       const Vector2& robot, const OpeningParameters& parameters,
                                       const ConfidenceParameters& confidence);

}  // namespace perceptor::identify
