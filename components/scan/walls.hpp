/// @file The wall that a run of beams shows: its line, fitted to all beams that support it,
/// its ends, and how certain both are.
#pragma once

#include <optional>
#include <vector>

#include "components/scan/runs.hpp"

namespace perceptor::scan {

/// The end of a wall.
struct WallEnd {
  Vector2 location{0.0, 0.0};  ///< [m] on the wall's line, robot frame
  Eigen::Matrix2d covariance;  ///< [m^2]
};

/// Directed counter-clockwise as seen from the laser: seen from its left.
struct Wall {
  Line line;  ///< through its middle
  WallEnd first;
  WallEnd last;
  Eigen::Matrix2d line_covariance;  ///< at its middle: perpendicular offset [m], angle [rad]
  std::size_t first_beam = 0;       ///< the first beam that supports it
  std::size_t last_beam = 0;        ///< the last beam that supports it, >= first_beam
  int support = 0;                  ///< beams that support it
};

/// Variance of a wall's line across itself at a place on it [m^2].
double variance_across(const Wall& wall, const Vector2& place);

/// Fits the run's wall; none where too few beams support it, or too small a share of those
/// between its ends, where it is too short, or its direction too uncertain.
std::optional<Wall> fit_wall(const Run& run, const Beams& beams, const ScanParameters& parameters);

}  // namespace perceptor::scan
