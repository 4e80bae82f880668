/// @file Keeps the local map: one scan's walls in, the walls that are known by now out.
///
/// For each scan: predict the robot's pose from odometry; register the scan's walls on the map;
/// forget what the scan sees through; merge the walls that are one; connect corners; confirm
/// what was seen again; forget what was not confirmed in time.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "components/merge/corners.hpp"
#include "components/merge/forgetting.hpp"
#include "components/merge/fusion.hpp"
#include "components/merge/registration.hpp"
#include "components/merge/same_wall.hpp"
#include "components/merge/sighting.hpp"

namespace perceptor::merge {

struct MergeParameters {
  int max_walls = 150;         ///< kept; beyond it the longest unseen is forgotten
  int max_rejected_scans = 5;  ///< in a row; then odometry is believed, and the map grows anew
  SightingParameters sighting;
  RegistrationParameters registration;
  SameWallParameters same_wall;
  FusionParameters fusion;
  CornerParameters corners;
  ConfirmationParameters confirmation;
  ForgettingParameters forgetting;
};

/// One scan as merge gets it.
struct ScanMap {
  std::int64_t utime = 0;   ///< [us]
  Position robot_in_zero;   ///< from odometry
  Position laser_in_robot;  ///< where the scan was taken from
  Map walls;                ///< robot frame
};

/// What is known after a scan.
struct LocalMap {
  Map walls;  ///< confirmed walls, robot frame; corners are connected points
  PoseEstimate robot_in_local;
  int registered = 0;     ///< walls of the scan that were laid on walls of the map
  bool rejected = false;  ///< the scan did not fit: odometry's pose stands, nothing was merged
  std::optional<double> unobservable_direction;  ///< [rad] robot frame, in (-pi/2, pi/2]
};

class Merger {
 public:
  explicit Merger(const MergeParameters& parameters) : parameters_(parameters) {}

  /// Scans in order of utime. The local frame is the zero frame of the first one.
  LocalMap update(const ScanMap& scan);

  /// Forgets everything: the next scan is the first.
  void clear();

  /// All walls, tentative ones too, local frame, in the order of their ids.
  const std::vector<Wall>& walls() const { return walls_; }

 private:
  struct Previous {
    std::int64_t utime = 0;
    Position robot_in_zero;
    PoseEstimate robot_in_local;
  };

  PoseEstimate predict_pose(const ScanMap& scan) const;
  bool is_to_be_merged(const Registration& registration);
  void merge_scan(const std::vector<Wall>& sighted, const PoseEstimate& robot_in_local,
                  const ScanMap& scan);
  std::vector<Observation> merge_sighted(const std::vector<Wall>& sighted, const Vector2& laser);
  void merge_doubles(const std::vector<Wall>& sighted, const Vector2& laser, std::int64_t utime,
                     std::vector<Observation>& seen);

  MergeParameters parameters_;
  std::vector<Wall> walls_;
  std::int32_t next_id_ = 0;
  int rejected_in_a_row_ = 0;
  std::optional<Previous> previous_;
};

}  // namespace perceptor::merge
