#include "tools/eval/world_doorways.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace perceptor {
namespace {

class DoorwayBuilder {
 public:
  DoorwayBuilder(WorldRooms& rooms, const std::vector<WallLine>& lines,
                 const WorldRoomParameters& parameters, RoomRandom& random)
      : rooms_(rooms), lines_(lines), parameters_(parameters), random_(random) {}

  bool add_doorways() {
    std::vector<Place> free = places();
    for (std::size_t i = free.size(); i > 1; --i)
      std::swap(free[i - 1],
                free[static_cast<std::size_t>(uniform_int(random_, 0, static_cast<int>(i) - 1))]);
    std::vector<std::size_t> group(rooms_.rooms.size());
    std::iota(group.begin(), group.end(), std::size_t{0});
    for (const Place& place : free) {
      const std::size_t joined = group[place.room];
      const std::size_t other = group[place.other_room];
      const bool is_wide_enough = place.to - place.from > parameters_.min_driven_door;
      if (joined != other && is_wide_enough) {
        std::ranges::replace(group, other, joined);
        add_doorway(place, parameters_.min_driven_door, parameters_.max_door, true);
      } else if (happens(random_, parameters_.extra_doors)) {
        add_doorway(place, parameters_.min_door, parameters_.max_extra_door, false);
      }
    }
    return std::ranges::all_of(group, [&](std::size_t g) { return g == group.front(); });
  }

 private:
  const WallLine& line(int index) const { return lines_[static_cast<std::size_t>(index)]; }

  /// Where two rooms share a wall, and a doorway fits.
  struct Place {
    std::size_t room;
    std::size_t other_room;
    int line;
    double from;  ///< [m] along the line
    double to;    ///< [m]
  };

  std::pair<double, double> interval(const RoomSide& side) const {
    return std::minmax(
        {line(side.line).along(side.segment.a), line(side.line).along(side.segment.b)});
  }

  std::vector<Place> places() const {
    std::vector<Place> found;
    for (std::size_t a = 0; a < rooms_.rooms.size(); ++a)
      for (std::size_t b = a + 1; b < rooms_.rooms.size(); ++b)
        for (const RoomSide& s : rooms_.rooms[a].sides)
          for (const RoomSide& t : rooms_.rooms[b].sides) {
            if (s.line < 0 || s.line != t.line) continue;
            const auto [s_from, s_to] = interval(s);
            const auto [t_from, t_to] = interval(t);
            const double from = std::max(s_from, t_from) + parameters_.door_margin;
            const double to = std::min(s_to, t_to) - parameters_.door_margin;
            if (to - from > parameters_.min_door) found.push_back({a, b, s.line, from, to});
          }
    return found;
  }

  void add_doorway(const Place& place, double min_width, double max_width, bool is_driven) {
    const double width = uniform(random_, min_width, std::min(max_width, place.to - place.from));
    const double from = uniform(random_, place.from, place.to - width);
    const WallLine& wall = line(place.line);
    const double aside = std::copysign(
        0.5 * wall.thickness, cross(wall.direction, centre(rooms_.rooms[place.room]) - wall.point));
    const auto face = [&](double offset) {
      return Segment{wall.at(from, offset), wall.at(from + width, offset)};
    };
    rooms_.doorways.push_back({place.room, place.other_room, face(aside), face(-aside), is_driven});
  }

  WorldRooms& rooms_;
  const std::vector<WallLine>& lines_;
  const WorldRoomParameters& parameters_;
  RoomRandom& random_;
};

}  // namespace

bool add_doorways(WorldRooms& rooms, const std::vector<WallLine>& lines,
                  const WorldRoomParameters& parameters, RoomRandom& random) {
  return DoorwayBuilder(rooms, lines, parameters, random).add_doorways();
}

}  // namespace perceptor
