#include "tools/eval/world_rooms.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "tools/eval/wall_line.hpp"
#include "tools/eval/world_doorways.hpp"

namespace perceptor {
namespace {

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
    if (!add_doorways(rooms_, lines_, parameters_, random_)) return std::nullopt;
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

}  // namespace

std::optional<WorldRooms> draw_world_rooms(const WorldRoomParameters& parameters,
                                           RoomRandom& random) {
  return Builder(parameters, random).build();
}

}  // namespace perceptor
