#include <algorithm>
#include <array>

#include "tools/eval/world_rooms.hpp"

namespace perceptor {
namespace {

/// The pieces of a room's side that are left beside the doorways in it.
void append_pieces(const Segment& side, std::vector<std::array<double, 2>> gaps,
                   std::vector<Segment>& pieces) {
  std::ranges::sort(gaps);
  const Vector2 along = direction(side);
  double from = 0.0;
  for (const auto& [gap_from, gap_to] : gaps) {
    pieces.push_back({side.a + from * along, side.a + gap_from * along});
    from = gap_to;
  }
  pieces.push_back({side.a + from * along, side.b});
}

bool lies_on(const Segment& face, const Segment& side) {
  constexpr double kOnIt = 1e-6;  // [m]
  return distance(side, face.a) < kOnIt && distance(side, face.b) < kOnIt;
}

}  // namespace

Vector2 centre(const WorldRoom& room) {
  Vector2 sum = Vector2::Zero();
  for (const RoomSide& side : room.sides) sum += side.segment.a;
  return sum / static_cast<double>(room.sides.size());
}

std::vector<Segment> walls(const WorldRooms& rooms) {
  std::vector<Segment> pieces;
  for (const WorldRoom& room : rooms.rooms)
    for (const RoomSide& side : room.sides) {
      std::vector<std::array<double, 2>> gaps;
      for (const Doorway& doorway : rooms.doorways)
        for (const Segment& face : {doorway.face, doorway.other_face})
          if (lies_on(face, side.segment)) gaps.push_back(projected_interval(side.segment, face));
      append_pieces(side.segment, gaps, pieces);
    }
  for (const Doorway& doorway : rooms.doorways) {
    pieces.push_back({doorway.face.a, doorway.other_face.a});
    pieces.push_back({doorway.face.b, doorway.other_face.b});
  }
  return pieces;
}

}  // namespace perceptor
