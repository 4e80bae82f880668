#include "tools/eval/random_world.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "common/geometry/polygon.hpp"

namespace perceptor {
namespace {

constexpr int kTries = 60;  // for one thing that has to fit somewhere

double separation(const std::vector<Segment>& some, const std::vector<Segment>& others) {
  double nearest = 1e9;
  for (const Segment& s : some)
    for (const Segment& t : others) nearest = std::min(nearest, distance(s, t));
  return nearest;
}

std::vector<Vector2> outline(const WorldRoom& room) {
  std::vector<Vector2> corners;
  for (const RoomSide& side : room.sides) corners.push_back(side.segment.a);
  return corners;
}

class Furnisher {
 public:
  Furnisher(const RandomWorldParameters& parameters, RoomRandom& random, RandomWorld& world)
      : parameters_(parameters),
        random_(random),
        world_(world),
        walls_(walls(world.rooms)),
        way_(legs(world.tour)) {}

  void furnish() {
    for (const WorldRoom& room : world_.rooms.rooms) {
      if (room.is_corridor) continue;
      if (happens(random_, parameters_.cabinets)) add_cabinet(room);
      if (happens(random_, parameters_.boxes)) add_box(room);
    }
    const int people = uniform_int(random_, 1, parameters_.max_people);
    for (int i = 0; i < people; ++i) add_person();
  }

 private:
  bool fits(const Furniture& furniture, double wall_gap) const {
    const std::vector<Segment> own = sides(furniture);
    return separation(own, walls_) > wall_gap && separation(own, taken_) > 0.6 &&
           separation(own, way_) > parameters_.furniture_gap;
  }

  void place(const Furniture& furniture, std::vector<Furniture>& list) {
    list.push_back(furniture);
    for (const Segment& side : sides(furniture)) taken_.push_back(side);
  }

  /// Along a wall, with a narrow gap behind it.
  void add_cabinet(const WorldRoom& room) {
    for (int i = 0; i < kTries; ++i) {
      const auto last = static_cast<int>(room.sides.size()) - 1;
      const Segment& wall =
          room.sides[static_cast<std::size_t>(uniform_int(random_, 0, last))].segment;
      const double gap = uniform(random_, 0.03, 0.2);
      Furniture cabinet{{}, uniform(random_, 0.4, 0.8), uniform(random_, 0.35, 0.45)};
      const Vector2 middle = wall.a + uniform(random_, 0.1, 0.9) * (wall.b - wall.a) +
                             (gap + 0.5 * cabinet.width) * perpendicular(direction(wall));
      cabinet.in_world = {middle.x(), middle.y(), angle(wall)};
      if (fits(cabinet, 0.025)) return place(cabinet, world_.cabinets);
    }
  }

  void add_box(const WorldRoom& room) {
    for (int i = 0; i < kTries; ++i) {
      const Vector2 middle = point_in(room);
      const Furniture box{{middle.x(), middle.y(), uniform_angle(random_)},
                          uniform(random_, 0.3, 0.7),
                          uniform(random_, 0.3, 0.5)};
      if (contains(outline(room), middle) && fits(box, 0.05)) return place(box, world_.boxes);
    }
  }

  void add_person() {
    constexpr double kRoomToWalk = 0.35;  // [m] to walls and furniture
    const auto is_off_the_way = [&](const Vector2& end) {
      return separation({{end, end}}, way_) > kGivesWayWithin + 0.05;
    };
    for (int i = 0; i < 5 * kTries; ++i) {
      const auto last = static_cast<int>(world_.rooms.rooms.size()) - 1;
      const WorldRoom& room =
          world_.rooms.rooms[static_cast<std::size_t>(uniform_int(random_, 0, last))];
      const Segment path{point_in(room), point_in(room)};
      const bool is_inside =
          contains(outline(room), path.a) && separation({path}, walls_) > kRoomToWalk;
      const bool is_free = separation({path}, taken_) > kRoomToWalk &&
                           distance(path.a, world_.start_in_world.location()) > 1.3;
      // See kWaitsWithin.
      const bool can_turn_back = is_off_the_way(path.a) && is_off_the_way(path.b);
      if (!is_inside || !is_free || !can_turn_back || length(path) < 1.0) continue;
      world_.people.push_back({path, uniform(random_, 0.4, 0.9)});
      return;
    }
  }

  Vector2 point_in(const WorldRoom& room) {
    Vector2 low = room.sides.front().segment.a;
    Vector2 high = low;
    for (const RoomSide& side : room.sides) {
      low = low.cwiseMin(side.segment.a);
      high = high.cwiseMax(side.segment.a);
    }
    const double x = uniform(random_, low.x(), high.x());
    return {x, uniform(random_, low.y(), high.y())};
  }

  const RandomWorldParameters& parameters_;
  RoomRandom& random_;
  RandomWorld& world_;
  std::vector<Segment> walls_;
  std::vector<Segment> way_;
  std::vector<Segment> taken_;  ///< sides of the furniture so far
};

}  // namespace

std::vector<Segment> sides(const Furniture& furniture) {
  const double x = 0.5 * furniture.length;
  const double y = 0.5 * furniture.width;
  const std::array<Vector2, 4> corners = {Vector2(-x, -y), Vector2(x, -y), Vector2(x, y),
                                          Vector2(-x, y)};
  std::vector<Segment> found;
  for (std::size_t i = 0; i < corners.size(); ++i)
    found.push_back(
        transform(furniture.in_world, Segment{corners[i], corners[(i + 1) % corners.size()]}));
  return found;
}

RandomWorld draw_random_world(const RandomWorldParameters& parameters, std::size_t number) {
  RoomRandom random = make_room_stream(parameters.seed, number, RoomStream::plan);
  while (true) {
    std::optional<WorldRooms> rooms = draw_world_rooms(parameters.rooms, random);
    if (!rooms) continue;
    RandomWorld world;
    world.rooms = std::move(*rooms);
    world.tour = draw_world_tour(world.rooms, parameters.tour, random);
    if (separation(legs(world.tour), walls(world.rooms)) < parameters.clearance) continue;
    const Vector2 start = world.tour.front().location;
    world.start_in_world = {start.x(), start.y(), uniform_angle(random)};
    world.start_in_odometry = {uniform(random, -4.0, 4.0), uniform(random, -4.0, 4.0),
                               uniform_angle(random)};
    Furnisher(parameters, random, world).furnish();
    if (world.people.empty()) continue;
    return world;
  }
}

}  // namespace perceptor
