#include "tools/eval/world_tour.hpp"

#include <cmath>
#include <utility>

namespace perceptor {
namespace {

class Guide {
 public:
  Guide(const WorldRooms& rooms, const WorldTourParameters& parameters, RoomRandom& random)
      : rooms_(rooms), parameters_(parameters), random_(random), visited_(rooms.rooms.size()) {}

  std::vector<TourStop> tour() {
    visit(0);
    return std::move(stops_);
  }

 private:
  /// In front of a doorway, in the room that `face` belongs to.
  Vector2 before(const Segment& face, const Segment& other_face) const {
    return middle(face) + parameters_.approach * unit(middle(face) - middle(other_face));
  }

  void visit(std::size_t room) {
    visited_[room] = true;
    const Vector2 middle_of_room = centre(rooms_.rooms[room]);
    const double turn = uniform(random_, parameters_.min_turn, parameters_.max_turn);
    stops_.push_back({middle_of_room, happens(random_, 0.5) ? turn : -turn});
    for (const Doorway& doorway : rooms_.doorways) {
      if (doorway.room != room && doorway.other_room != room) continue;
      const bool from_face = doorway.room == room;
      const Segment& near = from_face ? doorway.face : doorway.other_face;
      const Segment& far = from_face ? doorway.other_face : doorway.face;
      const std::size_t next = from_face ? doorway.other_room : doorway.room;
      if (!doorway.is_driven) {
        stops_.push_back({before(near, far), 0.0});
      } else if (!visited_[next]) {
        stops_.push_back({before(near, far), 0.0});
        stops_.push_back({before(far, near), 0.0});
        visit(next);
        stops_.push_back({before(far, near), 0.0});
        stops_.push_back({before(near, far), 0.0});
      } else {
        continue;
      }
      stops_.push_back({middle_of_room, 0.0});
    }
  }

  const WorldRooms& rooms_;
  const WorldTourParameters& parameters_;
  RoomRandom& random_;
  std::vector<bool> visited_;
  std::vector<TourStop> stops_;
};

}  // namespace

std::vector<TourStop> draw_world_tour(const WorldRooms& rooms,
                                      const WorldTourParameters& parameters, RoomRandom& random) {
  return Guide(rooms, parameters, random).tour();
}

std::vector<Segment> legs(const std::vector<TourStop>& tour) {
  std::vector<Segment> pieces;
  for (std::size_t i = 0; i < tour.size(); ++i)
    pieces.push_back({tour[i].location, tour[(i + 1) % tour.size()].location});
  return pieces;
}

}  // namespace perceptor
