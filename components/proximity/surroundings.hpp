/// @file What is near the robot, in sectors around its centre.
#pragma once

#include <limits>
#include <vector>

#include "common/model/laser_scan.hpp"

namespace perceptor {

struct ProximityParameters {
  double radius = 0.35;  ///< [m] from the robot's centre; closer is too close
  int num_sectors = 36;  ///< at least one; more make directions finer, and more sectors blind where
                         ///< beams are sparse; with sectors of less than 3 degrees
                         ///< a sliver of the robot itself can pass for a contact
  double contact_share = 0.25;  ///< share of a sector's angle that a body inside the footprint
                                ///< has to cover to be a contact; less takes a sliver of the
                                ///< robot itself for a body
  int min_beams_for_seen = 1;   ///< usable beams below which a sector is blind
};

/// One sector, as seen from the robot's centre.
struct Sector {
  bool too_close = false;  ///< something is closer than the radius
  bool blind = true;       ///< nothing is known about it: not free, not occupied
  bool contact = false;    ///< a body fills it from inside the footprint
  double distance = std::numeric_limits<double>::infinity();  ///< [m] to the nearest thing
  double bearing = 0.0;  ///< [rad] of it, robot frame; 0 where nothing is seen
};

struct Surroundings {
  std::vector<Sector> sectors;  ///< sector i begins at bearing -pi + i * 2 pi / num_sectors
  double nearest_distance = std::numeric_limits<double>::infinity();  ///< [m] over all sectors
  double nearest_bearing = 0.0;  ///< [rad] of it, robot frame; 0 where nothing is seen
  int own_beams = 0;             ///< beams left out because they hit the robot itself
};

/// Sorts the ends of all beams that returned into the sectors in which they lie, seen from the
/// robot's centre, wherever the laser is mounted. The robot is taken to stand still during the
/// sweep. Distances and bearings are those of beam ends, from the robot's centre.
///
/// - *own body*: a beam that ends inside the footprint ([m], robot frame, its edge included)
///   hits the robot itself and is left out, unless it is part of a contact.
/// - *contact*: of the beams that end in the sector, most end inside the footprint, and what
///   they hit covers at least `contact_share` of the sector's angle. Each beam stands for the
///   angle half-way to its neighbours (no more than the scan's median gap to either side),
///   laid out at its own range. A contact is too close whatever the radius.
/// - *blind*: fewer than `min_beams_for_seen` usable beams end in the sector. So it is blind
///   outside the field of view, where no beam returned (no return is unknown, never free; so
///   is a range beyond valid_max), in the shadow of something nearer, and between the beams of
///   a coarse laser. A single close beam in a blind sector still makes it too close.
///
/// Beams may be in any order and number; a scan without beams leaves every sector blind.
Surroundings look_around(const LaserScan& scan, const std::vector<Vector2>& footprint,
                         const ProximityParameters& parameters);

}  // namespace perceptor
