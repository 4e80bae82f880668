/// @file What a laser sees of the simulated world from where it truly is. It shares no code with
/// the simulator: the sides are swept one by one over the beams, the nearest hit of a beam stays.
#pragma once

#include <cstddef>
#include <vector>

#include "common/geometry/segment.hpp"
#include "tools/eval/true_world.hpp"

namespace perceptor {

/// The beams of a scan.
struct BeamFan {
  std::size_t beams = 0;
  double angle_min = 0.0;        ///< [rad] bearing of the first beam, laser frame
  double angle_increment = 0.0;  ///< [rad] from beam to beam, positive
  double reach = 8.0;            ///< [m] what is hit farther away is not seen
};

/// Something round that stands in the way, and is no part of the world: a person.
struct Body {
  Vector2 centre = Vector2::Zero();  ///< [m] world frame
  double radius = 0.0;               ///< [m]
};

/// What one beam hit.
struct BeamHit {
  std::size_t side = kNoSide;  ///< in TrueWorld::sides; none: nothing, or a body
  double along = 0.0;          ///< [m] on that side, from its first end
  double range = 0.0;          ///< [m]
};

/// One for each beam, in their order.
std::vector<BeamHit> cast_beams(const TrueWorld& world, const std::vector<Body>& bodies,
                                const Position& laser_in_world, const BeamFan& fan);

/// A stretch of a side [m] along it.
struct Stretch {
  double from = 0.0;
  double to = 0.0;
};

/// What one scan shows of one side.
struct SideView {
  std::size_t beams = 0;
  std::vector<Stretch> stretches;  ///< in no particular order

  double seen() const;  ///< [m] in all
  /// [m] from a place on the side to the nearest that is seen; infinite where nothing is.
  double distance_to(double along) const;
};

/// One for each side of the world. Between neighbouring beams that hit a side no farther apart
/// than `max_gap` [m], the side is seen.
std::vector<SideView> side_views(const std::vector<BeamHit>& hits, std::size_t sides,
                                 double max_gap);

}  // namespace perceptor
