/// @file Random numbers of the rooms: one seed gives the same rooms and ranges whatever standard
/// library the program stands on. The standard fixes the generator's numbers, but not what its
/// distributions make of them: these do.
#pragma once

#include <cstdint>
#include <random>

namespace perceptor {

using RoomRandom = std::mt19937_64;

/// What is random about a scan. Each has a stream of its own, so that switching one on, or asking
/// for more scans, changes nothing else.
enum class RoomStream : std::uint32_t { plan = 1, pose, range_noise, outliers, dropouts };

/// The stream of one thing of one scan.
RoomRandom make_room_stream(std::uint64_t seed, std::uint64_t scan, RoomStream stream);

/// In [low, high).
double uniform(RoomRandom& random, double low, double high);

/// In [low, high], both included.
int uniform_int(RoomRandom& random, int low, int high);

/// [rad] In [-pi, pi).
double uniform_angle(RoomRandom& random);

/// Whether something happens that has this share of all cases.
bool happens(RoomRandom& random, double share);

/// Mean 0, standard deviation 1; Box and Muller's transform of two uniform numbers.
double normal(RoomRandom& random);

}  // namespace perceptor
