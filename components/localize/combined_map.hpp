/// @file The building's map with what the robot found of it: which walls are there, which doors
/// are open, and what stands about that the map does not have.
///
/// Scans count only while they fit the pose better than they fit poses beside it: laid out askew
/// every wall would look like something new.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "common/geometry/pose_estimate.hpp"
#include "common/model/laser_scan.hpp"
#include "common/model/map.hpp"
#include "components/localize/beam_fit.hpp"
#include "components/localize/unknown_objects.hpp"
#include "components/localize/world.hpp"

namespace perceptor::localize {

struct CombinedMapParameters {
  int beams = 120;             ///< of a scan, evenly chosen
  double max_sigma = 0.1;      ///< [m] of the pose; less certain, and the scan does not count
  double max_angle = 0.05;     ///< [rad] the same
  double check_period = 0.5;   ///< [s] until the pose has to beat its neighbours again
  double beside = 0.2;         ///< [m] how far these are
  double askew = 0.1;          ///< [rad] and twice that: the same
  double tolerance = 0.2;      ///< [m] a beam that ends this close to a face ends on it
  double through = 0.3;        ///< [m] one that ends so far behind it passes through
  double wall = 10.0;          ///< beams that confirm or contradict a wall, in balance
  double most_wall = 100.0;    ///< the balance goes no further: what was seen can change
  double door_middle = 0.7;    ///< share of a doorway's width that tells
  double min_incidence = 0.3;  ///< sine of a beam's angle to the doorway
  double leaf = 0.25;          ///< [m] from the wall's faces: where a leaf may stand
  double door_memory = 0.4;    ///< [s] in which what was seen of a doorway fades
  double door = 4.0;           ///< beams that tell its state
  double max_range = 6.0;      ///< [m] unknown things farther away are not looked at
  UnknownObjectParameters objects;
};

class CombinedMap {
 public:
  /// `global_map`: the one of which the world was made.
  CombinedMap(const World& world, Map global_map, const BeamFitParameters& fit,
              const CombinedMapParameters& parameters);

  /// One scan from a claimed pose. `ends` in the order of their bearings, robot frame.
  void add(const PoseEstimate& robot_in_world, const std::vector<BeamEnd>& ends,
           std::int64_t utime);

  /// World frame: the walls and cabinets of the global map, each "confirmed", "unseen" or
  /// "contradicted" by its reason, the balance of beams as its weight; every doorway as a door,
  /// "open", "shut" or "unseen", with the confidence of that; obstacles, static and dynamic.
  Map map(std::int64_t utime);

  /// All that was seen was seen from a wrong place.
  void clear();

 private:
  struct Presence {
    double balance = 0.0;        ///< beams for it less beams against it
    std::int64_t last_seen = 0;  ///< [us]
  };
  struct DoorState {
    double open = 0.0;       ///< beams that passed, fading
    double shut = 0.0;       ///< beams that ended there, fading
    std::int64_t faded = 0;  ///< [us] until when
    std::optional<bool> is_open;
    double confidence = 0.0;
    std::int64_t last_seen = 0;  ///< [us]
  };

  bool is_trusted(const PoseEstimate& robot_in_world, const std::vector<BeamEnd>& ends,
                  std::int64_t utime);
  bool fits_best(const Position& robot_in_world, const std::vector<Beam>& beams) const;
  void watch_face(const WorldBeam& beam, const RayHit& met, std::int64_t utime);
  bool watch_door(const WorldBeam& beam, std::size_t doorway, std::int64_t utime);
  void decide(DoorState& door, std::int64_t utime) const;
  bool is_unknown(const WorldBeam& beam, const RayHit& met) const;
  void describe_wall(Object& wall, const Presence& presence) const;

  const World& world_;
  Map global_map_;
  BeamFitParameters fit_;
  CombinedMapParameters parameters_;
  std::vector<Presence> objects_on_map_;  ///< as in the global map
  std::vector<DoorState> doors_;          ///< as in World::doorways
  UnknownObjects objects_;
  bool trusted_ = false;
  std::optional<std::int64_t> checked_;  ///< [us]
};

}  // namespace perceptor::localize
