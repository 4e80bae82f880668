/// @file What became of a trial, by the protocol.
#pragma once

#include <optional>
#include <vector>

#include "tools/eval/localize/drive.hpp"

namespace perceptor {

constexpr double kSoon = 10.0;  ///< [s] in which most should be found

struct OutcomeParameters {
  double distance = 0.1;     ///< [m] from the truth: found
  double angle = 0.035;      ///< [rad] the same: 2 degrees
  double held = 10.0;        ///< [s] so long
  double false_after = 1.0;  ///< [s] tracking elsewhere for longer is a false claim
  double settled = 1.0;      ///< [s] after being found errors count
};

/// Squared errors while the robot was found.
struct TrackingError {
  double squared_distance = 0.0;  ///< [m^2] sum
  double squared_angle = 0.0;     ///< [rad^2] sum
  double nees = 0.0;              ///< sum of the error normalised by the covariance, squared
  int fixes = 0;

  TrackingError& operator+=(const TrackingError& other);
};

struct Outcome {
  std::optional<double> found;         ///< [s] when it was there, to stay for a while
  double longest_false = 0.0;          ///< [s] tracking elsewhere, at a stretch
  bool is_ambiguous = false;           ///< elsewhere the drive would have looked the same
  bool is_ambiguous_at_first = false;  ///< of what it saw in the first kSoon the same is true
  bool said_ambiguous = false;
  TrackingError error;
  CombinedScore combined;
  bool was_tracking = false;          ///< when it was kidnapped: there is something to notice
  bool is_ambiguous_after = false;    ///< the same of where it was carried to
  std::optional<double> noticed;      ///< [s] after it was kidnapped
  std::optional<double> found_again;  ///< [s] the same
};

/// All but what the oracle says.
Outcome judge(const Drive& drive, const OutcomeParameters& parameters = {});

}  // namespace perceptor
