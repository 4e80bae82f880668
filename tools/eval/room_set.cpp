#include "tools/eval/room_set.hpp"

#include <stdexcept>

namespace perceptor {

LabelledScan make_room_scan(const RoomScanParameters& parameters, std::size_t number) {
  if (parameters.kinds.empty()) throw std::invalid_argument("no kinds of rooms to make");
  const RoomKind kind = parameters.kinds[number % parameters.kinds.size()];
  RoomRandom plan_random = make_room_stream(parameters.seed, number, RoomStream::plan);
  RoomRandom pose_random = make_room_stream(parameters.seed, number, RoomStream::pose);
  const FloorPlan plan = make_room(kind, plan_random);
  const Position laser_in_world = free_pose(plan, pose_random, parameters.min_clearance);
  return scan_room(walls(plan), laser_in_world, parameters.laser, parameters.seed, number);
}

ScanSet make_room_scans(const RoomScanParameters& parameters) {
  ScanSet set;
  set.has_truth = true;
  for (std::size_t number = 0; number < parameters.scans; ++number)
    set.scans.push_back(make_room_scan(parameters, number));
  return set;
}

}  // namespace perceptor
