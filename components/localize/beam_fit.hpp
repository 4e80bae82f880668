/// @file How well the beams of a scan fit a pose in the known building.
///
/// Each range is judged by the mixture of S. Thrun, W. Burgard and D. Fox, "Probabilistic
/// Robotics" (2005), 6.3: what the map says, something unknown in front of it, anything. A beam
/// that ends too short is common (clutter, people); one that goes through a wall is not.
#pragma once

#include <vector>

#include "common/geometry/position.hpp"
#include "common/model/laser_scan.hpp"
#include "components/localize/world.hpp"

namespace perceptor::localize {

/// Where a beam began and ended, robot frame.
struct Beam {
  Vector2 origin;     ///< [m]
  Vector2 direction;  ///< unit vector
  double range;       ///< [m]
};

struct BeamFitParameters {
  int beams = 72;           ///< of a scan, evenly chosen
  double sigma = 0.05;      ///< [m] of a range: noise, and walls that stand off the map
  double hit = 0.6;         ///< share of the beams that end where the map says
  double in_front = 0.35;   ///< share that end at something unknown before that
  double anything = 0.05;   ///< share that measure anything
  double behind = 1e-8;     ///< share that measure anything behind a wall: people look like boxes,
                            ///< but nobody sees through walls
  double through = 0.2;     ///< [m] a range longer than the map says by more goes through a wall
  double max_range = 10.0;  ///< [m] of the beams that measure anything
};

/// Within so many sigmas a beam ends where the map says.
inline constexpr double kHitSigmas = 3.0;

struct BeamFit {
  double log_likelihood = 0.0;
  double explained = 0.0;  ///< share of the beams that end where the map says
  double through = 0.0;    ///< share that go through a wall of the map
};

/// Evenly from `ends`, which are in the order of their bearings; at most `count`. A beam that ends
/// far from where both its neighbours do measured anything at all, and is left out.
std::vector<Beam> choose_beams(const std::vector<BeamEnd>& ends, int count);

BeamFit fit_beams(const World& world, const Position& robot_in_world,
                  const std::vector<Beam>& beams, const BeamFitParameters& parameters);

}  // namespace perceptor::localize
