/// @file The wall that a run of beams shows: its line, fitted to all beams that support it,
/// its ends, and how certain both are.
#pragma once

#include <cstddef>

#include <Eigen/Core>

#include "components/scan/runs.hpp"

namespace perceptor::scan {

/// The end of a wall, or a corner.
struct WallEnd {
  Vector2 location{0.0, 0.0};  ///< [m] robot frame
  Eigen::Matrix2d covariance;  ///< [m^2]
};

/// Directed counter-clockwise as seen from the laser: seen from its left.
struct Wall {
  Line line;                        ///< through its middle
  WallEnd first;                    ///< on its line, by the first beam that supports it
  WallEnd last;                     ///< on its line, by the last beam that supports it
  Eigen::Matrix2d line_covariance;  ///< at its middle: perpendicular offset [m], angle [rad]
  std::size_t first_beam = 0;       ///< the first beam that supports it, index into Beams
  std::size_t last_beam = 0;        ///< the last beam that supports it, >= first_beam
  int support = 0;                  ///< beams that support it
  double excess = 1.0;  ///< [-] their variance about the line over what the noise says, at least 1
};

/// What became of a run.
enum class Verdict {
  wall,
  too_few_beams,  ///< that support a line: WallParameters::min_beams
  too_scattered,  ///< too small a share of them supports it: min_support_share
  too_short,      ///< min_length
  too_uncertain,  ///< its direction: max_angle_sigma
};

/// Variance of a wall's line across itself at a place on it [m^2].
double variance_across(const Wall& wall, const Vector2& place);

/// Standard deviation of its direction [rad].
double angle_sigma(const Wall& wall);

/// Between its ends [m].
double length(const Wall& wall);

/// Share of the beams between its first and its last that support it [-].
double support_share(const Wall& wall);

/// Whether a beam is no further from the wall's line than `support_sigmas`.
bool supports(const Beams& beams, std::size_t i, const Wall& wall,
              const ScanParameters& parameters);

/// Fits the run's wall into `wall`. Where the verdict is another than `wall`, what was found up
/// to there is filled in.
Verdict fit_wall(const Run& run, const Sweep& sweep, const ScanParameters& parameters, Wall& wall);

}  // namespace perceptor::scan
