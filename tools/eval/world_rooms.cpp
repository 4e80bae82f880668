#include "tools/eval/world_rooms.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

namespace perceptor {
namespace {

/// The middle of a wall, without end.
struct WallLine {
  Vector2 point = Vector2::Zero();
  Vector2 direction = Vector2::UnitX();
  double thickness = 0.0;  ///< [m]

  /// On the wall's middle, `along` [m] from its point, `aside` [m] to the left.
  Vector2 at(double along, double aside) const {
    return point + along * direction + aside * perpendicular(direction);
  }
  double along(const Vector2& p) const { return (p - point).dot(direction); }
};

Vector2 meeting_point(const WallLine& s, double s_aside, const WallLine& t, double t_aside) {
  const Vector2 from = s.at(0.0, s_aside);
  const Vector2 to = t.at(0.0, t_aside);
  return from + s.direction * (cross(to - from, t.direction) / cross(s.direction, t.direction));
}

class Builder {
 public:
  Builder(const WorldRoomParameters& parameters, RoomRandom& random)
      : parameters_(parameters), random_(random) {}

  std::optional<WorldRooms> build() {
    add_rows();
    const std::size_t rooms = rooms_.rooms.size();
    if (rooms < parameters_.min_rooms || rooms > parameters_.max_rooms) return std::nullopt;
    if (!add_doorways()) return std::nullopt;
    turn();
    return std::move(rooms_);
  }

 private:
  int add_line(const Vector2& from, const Vector2& to) {
    lines_.push_back({from, unit(to - from),
                      uniform(random_, parameters_.min_thickness, parameters_.max_thickness)});
    return static_cast<int>(lines_.size()) - 1;
  }

  const WallLine& line(int index) const { return lines_[static_cast<std::size_t>(index)]; }

  void add_rows() {
    const double width = uniform(random_, 5.5, 9.0);
    const bool has_corridor = happens(random_, parameters_.corridors);
    const int rows = has_corridor ? uniform_int(random_, 2, 3) : 2;
    const int corridor = has_corridor ? 1 : -1;
    const auto slant = [&] {
      return width * uniform(random_, -parameters_.max_row_slant, parameters_.max_row_slant);
    };
    double y = 0.0;
    double rise = slant();
    int below = add_line({0.0, y}, {width, y + rise});
    for (int row = 0; row < rows; ++row) {
      const bool is_corridor = row == corridor;
      // A corridor's walls are parallel, or it would close.
      if (!is_corridor) rise = slant();
      y += is_corridor ? uniform(random_, parameters_.min_corridor, parameters_.max_corridor)
                       : uniform(random_, 2.6, 3.6);
      const int above = add_line({0.0, y}, {width, y + rise});
      add_row(below, above, width, is_corridor);
      below = above;
    }
  }

  void add_row(int below, int above, double width, bool is_corridor) {
    const int most = width > 7.0 ? 3 : 2;
    const int rooms = is_corridor ? 1 : uniform_int(random_, 1, most);
    const double share = width / rooms;
    int left = add_cross_wall(0.0, line(below), line(above));
    for (int i = 1; i <= rooms; ++i) {
      const double middle = share * i + (i < rooms ? uniform(random_, -0.3, 0.3) : 0.0);
      const int right = add_cross_wall(middle, line(below), line(above));
      add_room({below, right, above, left}, is_corridor);
      left = right;
    }
  }

  int add_cross_wall(double x, const WallLine& below, const WallLine& above) {
    const double half = 0.5 * parameters_.max_cross_slant;
    const Vector2 bottom = below.at(x + uniform(random_, -half, half), 0.0);
    const Vector2 top = above.at(x + uniform(random_, -half, half), 0.0);
    return add_line(bottom, top);
  }

  /// Lines: below, right, above, left. The first runs rightwards, the cross walls upwards.
  void add_room(const std::array<int, 4>& lines, bool is_corridor) {
    constexpr std::array kAside = {+0.5, +0.5, -0.5, -0.5};  // towards the room
    const auto corner = [&](std::size_t s, std::size_t t) {
      return meeting_point(line(lines[s]), kAside[s] * line(lines[s]).thickness, line(lines[t]),
                           kAside[t] * line(lines[t]).thickness);
    };
    WorldRoom room;
    room.is_corridor = is_corridor;
    for (std::size_t i = 0; i < 4; ++i)
      room.sides.push_back({{corner((i + 3) % 4, i), corner(i, (i + 1) % 4)}, lines[i]});
    if (!is_corridor) cut_corners(room);
    rooms_.rooms.push_back(std::move(room));
  }

  void cut_corners(WorldRoom& room) {
    std::vector<RoomSide> sides;
    std::vector<RoomSide>& old = room.sides;
    for (std::size_t i = 0; i < old.size(); ++i) {
      RoomSide& next = old[(i + 1) % old.size()];
      sides.push_back(old[i]);
      if (!happens(random_, parameters_.chamfers)) continue;
      const Vector2 from = old[i].segment.b - direction(old[i].segment) * chamfer();
      const Vector2 to = next.segment.a + direction(next.segment) * chamfer();
      sides.back().segment.b = from;
      // The first side stands in the new list already.
      (i + 1 < old.size() ? next : sides.front()).segment.a = to;
      sides.push_back({{from, to}, -1});
    }
    room.sides = std::move(sides);
  }

  double chamfer() { return uniform(random_, parameters_.min_chamfer, parameters_.max_chamfer); }

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

  void turn() {
    if (!happens(random_, parameters_.turned)) return;
    const Position turned{0.0, 0.0, uniform(random_, -std::numbers::pi, std::numbers::pi)};
    for (WorldRoom& room : rooms_.rooms)
      for (RoomSide& side : room.sides) side.segment = transform(turned, side.segment);
    for (Doorway& doorway : rooms_.doorways) {
      doorway.face = transform(turned, doorway.face);
      doorway.other_face = transform(turned, doorway.other_face);
    }
  }

  const WorldRoomParameters& parameters_;
  RoomRandom& random_;
  std::vector<WallLine> lines_;
  WorldRooms rooms_;
};

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

std::optional<WorldRooms> draw_world_rooms(const WorldRoomParameters& parameters,
                                           RoomRandom& random) {
  return Builder(parameters, random).build();
}

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
