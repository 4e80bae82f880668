/// @file Text files that say where the robot was: poses, and relations between poses.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "tools/eval/trajectory.hpp"

namespace perceptor {

/// How the pose at one time looks from the pose at another.
struct Relation {
  std::int64_t from_utime = 0;
  std::int64_t to_utime = 0;
  Position to_in_from;
};

/// Lines `REF t x y theta`, in seconds, metres and radians; a fifth number (a scatter) is passed
/// over. In any order; of poses at one time the first stays. Plain or gzipped.
/// Throws TextFileError, also where there is none.
Trajectory read_poses(const std::filesystem::path& file);

/// Lines `t1 t2 x y z roll pitch yaw`: the pose at t2 seen from that at t1. What is not in the
/// plane (z, roll, pitch) is passed over. Plain or gzipped.
/// Throws TextFileError, also where there is none.
std::vector<Relation> read_relations(const std::filesystem::path& file);

}  // namespace perceptor
