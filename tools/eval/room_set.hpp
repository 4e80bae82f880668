/// @file A set of scans in random rooms, with the truth about them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "tools/eval/room_scan.hpp"
#include "tools/eval/rooms.hpp"
#include "tools/eval/scan_set.hpp"

namespace perceptor {

/// The same parameters give the same bytes. The rooms and the places in them depend on `seed`,
/// `kinds` and the number of the scan only: with another laser, or with more scans, the rooms
/// that were there stay as they are.
struct RoomScanParameters {
  std::size_t scans = 120;
  RoomLaser laser{};
  double min_clearance = 0.3;  ///< [m] of the laser from the walls
  std::uint64_t seed = 1;
  std::vector<RoomKind> kinds{kAllRoomKinds.begin(), kAllRoomKinds.end()};  ///< in turn
};

/// The scan of this number: a room of its own, seen from anywhere in it. Throws
/// std::invalid_argument where there are no kinds or fewer than two beams.
LabelledScan make_room_scan(const RoomScanParameters& parameters, std::size_t number);

/// All of them, numbered from 0.
ScanSet make_room_scans(const RoomScanParameters& parameters);

}  // namespace perceptor
