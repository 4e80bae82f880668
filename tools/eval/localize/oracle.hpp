/// @file Knows where the robot really was, and tells whether it could have been elsewhere.
///
/// The whole drive, moved rigidly to every other place of the building, is compared with what the
/// robot saw. Where as many beams end at something that the map has, and no more go through walls,
/// nobody could tell the places apart: `ambiguous` is then the right answer.
#pragma once

#include <optional>
#include <vector>

#include "components/localize/world.hpp"
#include "tools/eval/localize/drive.hpp"

namespace perceptor {

struct OracleParameters {
  double tolerance = 0.15;      ///< [m] of a range: displaced walls, noise
  double glance = 0.3;          ///< [m] the same while places are a grid's step off
  double step = 0.1;            ///< [m] of the grid
  double same_angle = 0.05;     ///< [rad] headings this close are tried once
  double fewer = 0.03;          ///< share of the beams that may be explained worse
  double more_through = 0.015;  ///< share that may go through walls beyond the truth's
  double same_place = 0.5;      ///< [m] that is not elsewhere
  double same_heading = 0.35;   ///< [rad] the same
};

/// Where else the robot could have begun; none: only where it did.
std::optional<Position> elsewhere(const localize::World& world, const std::vector<TrueView>& views,
                                  const OracleParameters& parameters = {});

}  // namespace perceptor
