#include "tools/eval/localize/trial.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "tools/eval/random_world.hpp"

namespace perceptor {
namespace {

constexpr int kTries = 200;
constexpr int kRays = 120;          // that measure how much of the view is cluttered
constexpr double kFarthest = 20.0;  // [m] a place from where more can be seen lies outside

Vector2 direction_of(double bearing) { return {std::cos(bearing), std::sin(bearing)}; }

/// [m] from a place, or from a way.
template <class Shape>
double clearance_of(const std::vector<Segment>& lines, const Shape& shape) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Segment& line : lines) nearest = std::min(nearest, distance(line, shape));
  return nearest;
}

template <class Choices>
auto any_of(const Choices& choices, RoomRandom& random) {
  return choices[static_cast<std::size_t>(
      uniform_int(random, 0, static_cast<int>(choices.size()) - 1))];
}

Conditions draw_conditions(const ProtocolParameters& parameters, RoomRandom& random) {
  Conditions conditions;
  conditions.clutter = any_of(std::array{0.0, 0.2, 0.4}, random);
  if (conditions.clutter > 0.0) conditions.people = uniform_int(random, 1, 3);
  conditions.doors = any_of(std::array{Doors::open, Doors::flush, Doors::recessed}, random);
  conditions.slip = any_of(std::array{0.002, 0.05, 0.1}, random);
  conditions.sigma = any_of(std::array{0.01, 0.03}, random);
  conditions.outliers = uniform(random, 0.01, 0.05);
  conditions.displaced = any_of(std::array{0.0, 0.05}, random);
  conditions.kidnapped = happens(random, parameters.kidnapped);
  return conditions;
}

/// How far the real building stands off its drawing: smooth, so that what is drawn at one place
/// stays together and a jamb stays square. Values on a lattice, linear between.
class Displacement {
 public:
  Displacement(double largest, RoomRandom& random) {
    for (Vector2& value : lattice_)
      value = uniform(random, 0.0, largest) * direction_of(uniform_angle(random));
  }

  Vector2 at(const Vector2& place) const {
    const Vector2 scaled = place / kCell;
    const Vector2 cell(std::floor(scaled.x()), std::floor(scaled.y()));
    const Vector2 within = scaled - cell;
    Vector2 sum = Vector2::Zero();
    for (const int i : {0, 1})
      for (const int j : {0, 1})
        sum += (i == 0 ? 1.0 - within.x() : within.x()) * (j == 0 ? 1.0 - within.y() : within.y()) *
               value(static_cast<int>(cell.x()) + i, static_cast<int>(cell.y()) + j);
    return sum;
  }

 private:
  static constexpr double kCell = 1.0;       // [m]
  static constexpr std::size_t kCells = 64;  // then it begins anew

  const Vector2& value(int i, int j) const {
    const auto wrapped = [](int k) {
      constexpr auto n = static_cast<int>(kCells);
      return static_cast<std::size_t>(((k % n) + n) % n);
    };
    return lattice_[wrapped(i) * kCells + wrapped(j)];
  }

  std::array<Vector2, kCells * kCells> lattice_;
};

class Drawer {
 public:
  Drawer(const Site& site, const ProtocolParameters& parameters, const Conditions& conditions,
         RoomRandom& random)
      : site_(site), parameters_(parameters), conditions_(conditions), random_(random) {}

  /// False where nothing fits: draw again.
  bool build(sim::SimulatorParameters& simulator) {
    build_walls(simulator.world);
    const auto start = any_start();
    if (!start || !clutter(*start, simulator.world)) return false;
    simulator.tour.points = drive(*start);
    if (simulator.tour.points.size() < 2) return false;
    simulator.start_in_world = {start->x(), start->y(), uniform_angle(random_)};
    add_people(*start, simulator.world);
    return true;
  }

  /// Another start in the same world, as it was built.
  bool carry_away(sim::SimulatorParameters& simulator) {
    const auto start = any_start();
    if (!start) return false;
    simulator.tour.points = drive(*start);
    simulator.start_in_world = {start->x(), start->y(), uniform_angle(random_)};
    return simulator.tour.points.size() >= 2;
  }

 private:
  void build_walls(sim::World& world) {
    const Displacement displacement(conditions_.displaced, random_);
    const auto displaced = [&](const Segment& line) {
      return Segment{line.a + displacement.at(line.a), line.b + displacement.at(line.b)};
    };
    for (const Segment& line : lines(site_.plan)) world.walls.push_back(displaced(line));
    closed_ = world.walls;
    for (const localize::Doorway& drawn : site_.world.doorways()) {
      const localize::Doorway doorway{displaced(drawn.opening), drawn.half_depth};
      doorways_.push_back(doorway);
      const std::vector<Segment> flush = flush_leaves(doorway);
      closed_.insert(closed_.end(), flush.begin(), flush.end());
      if (conditions_.doors == Doors::flush)
        world.walls.insert(world.walls.end(), flush.begin(), flush.end());
      if (conditions_.doors == Doors::recessed)
        world.walls.push_back(recessed_leaf(doorway, parameters_.recess));
    }
    lines_ = world.walls;
  }

  /// A place indoors with room around it.
  std::optional<Vector2> any_start() {
    Vector2 low = lines_.front().a;
    Vector2 high = low;
    for (const Segment& line : lines_) {
      low = low.cwiseMin(line.a).cwiseMin(line.b);
      high = high.cwiseMax(line.a).cwiseMax(line.b);
    }
    for (int i = 0; i < kTries; ++i) {
      const Vector2 place(uniform(random_, low.x(), high.x()), uniform(random_, low.y(), high.y()));
      if (clearance_of(closed_, place) > parameters_.clearance &&
          clearance_of(lines_, place) > parameters_.clearance && is_indoors(place))
        return place;
    }
    return std::nullopt;
  }

  bool is_indoors(const Vector2& place) const {
    const sim::Obstacles closed{closed_, {}, {}};
    for (int k = 0; k < kRays; k += 6)
      if (sim::cast_ray(place, bearing(k), closed) > kFarthest) return false;
    return true;
  }

  static double bearing(int ray) { return (ray + 0.5) * 2.0 * std::numbers::pi / kRays; }

  /// Boxes around, until so many beams end on them.
  bool clutter(const Vector2& start, sim::World& world) {
    const sim::Obstacles walls{lines_, {}, {}};
    std::vector<Segment> sides;
    for (int i = 0; i < kTries && conditions_.clutter > 0.0; ++i) {
      const double share = cluttered(start, walls, sides);
      if (share >= conditions_.clutter - parameters_.clutter_error) {
        lines_.insert(lines_.end(), sides.begin(), sides.end());
        return share <= conditions_.clutter + parameters_.clutter_error;
      }
      const double towards = uniform_angle(random_);
      const double far = uniform(random_, 0.7, 2.5);
      const Vector2 place = start + far * direction_of(towards);
      const sim::Box box{{place.x(), place.y(), uniform_angle(random_)},
                         uniform(random_, 0.2, 0.6),
                         uniform(random_, 0.2, 0.5)};
      const bool fits = far < sim::cast_ray(start, towards, walls) - 0.2 &&
                        far - std::hypot(box.length, box.width) / 2.0 > parameters_.clearance;
      if (!fits) continue;
      world.boxes.push_back(box);
      for (const Segment& side : edges(sim::outline(box))) sides.push_back(side);
    }
    return conditions_.clutter == 0.0;
  }

  static double cluttered(const Vector2& start, const sim::Obstacles& walls,
                          const std::vector<Segment>& sides) {
    const sim::Obstacles boxes{sides, {}, {}};
    int hidden = 0;
    for (int k = 0; k < kRays; ++k)
      if (sim::cast_ray(start, bearing(k), boxes) < sim::cast_ray(start, bearing(k), walls))
        ++hidden;
    return static_cast<double>(hidden) / kRays;
  }

  /// A turn in place, then where there is a way, there and back.
  std::vector<sim::Waypoint> drive(const Vector2& start) {
    constexpr std::size_t kPlaces = 5;
    std::vector<sim::Waypoint> points = {{start, uniform(random_, 3.5, 7.0), 0.0, -1}};
    Vector2 here = start;
    for (int i = 0; i < kTries && points.size() < kPlaces; ++i) {
      if (happens(random_, 0.3) && drive_through_door(here, points)) continue;
      const Vector2 there =
          here + uniform(random_, 0.4, 3.0) * direction_of(uniform_angle(random_));
      if (!is_free(Segment{here, there})) continue;
      points.push_back({there, uniform(random_, -3.0, 3.0), 0.0, -1});
      here = there;
    }
    for (std::size_t i = points.size() - 1; i-- > 1;) points.push_back({points[i].location});
    return points;
  }

  bool drive_through_door(Vector2& here, std::vector<sim::Waypoint>& points) {
    if (doorways_.empty()) return false;
    const Segment opening = any_of(doorways_, random_).opening;
    const Vector2 ahead = perpendicular(direction(opening));
    const Vector2 before = middle(opening) + 0.5 * ahead;
    const Vector2 behind = middle(opening) - 0.7 * ahead;
    if (!is_free({here, before}) || !is_free({before, behind})) return false;
    points.push_back({before});
    points.push_back({behind, uniform(random_, -3.0, 3.0)});
    here = behind;
    return true;
  }

  bool is_free(const Segment& way) const {
    return clearance_of(lines_, way) > parameters_.clearance;
  }

  void add_people(const Vector2& start, sim::World& world) {
    constexpr double kRoomForPerson = 0.3;  // [m]
    for (int i = 0; i < kTries && static_cast<int>(world.people.size()) < conditions_.people; ++i) {
      const auto somewhere = [&] {
        return Vector2(start.x() + uniform(random_, -2.5, 2.5),
                       start.y() + uniform(random_, -2.5, 2.5));
      };
      const Segment way{somewhere(), somewhere()};
      const bool fits = clearance_of(lines_, way) > kRoomForPerson && length(way) > 0.5 &&
                        distance(way.a, start) > 0.8 && distance(way.b, start) > 0.8;
      if (!fits) continue;
      sim::PersonParameters person;
      person.path = {way.a, way.b};
      person.speed = uniform(random_, 0.4, 1.0);
      person.waits_within = kWaitsWithin;
      world.people.push_back(person);
    }
  }

  const Site& site_;
  const ProtocolParameters& parameters_;
  const Conditions& conditions_;
  RoomRandom& random_;
  std::vector<Segment> lines_;               ///< that stand there: walls, leaves, boxes
  std::vector<Segment> closed_;              ///< walls, and openings as if they were shut
  std::vector<localize::Doorway> doorways_;  ///< where they really are
};

}  // namespace

Trial draw_trial(const std::vector<Site>& sites, const sim::SimulatorParameters& robot,
                 const ProtocolParameters& parameters, std::size_t number) {
  RoomRandom random = make_room_stream(parameters.seed, number, RoomStream::plan);
  while (true) {
    Trial trial;
    trial.number = number;
    trial.site =
        static_cast<std::size_t>(uniform_int(random, 0, static_cast<int>(sites.size()) - 1));
    trial.conditions = draw_conditions(parameters, random);
    trial.simulator = robot;
    trial.simulator.seed = static_cast<std::int64_t>(random() >> 1U);
    trial.simulator.odometry.start_in_odometry = {
        uniform(random, -3.0, 3.0), uniform(random, -3.0, 3.0), uniform_angle(random)};
    trial.simulator.odometry.slip_scale = trial.conditions.slip;
    trial.simulator.odometry.slip_walk = trial.conditions.slip / 5.0;
    trial.simulator.odometry.slip_turn_walk = trial.conditions.slip / 5.0;
    trial.simulator.laser.noise_sigma = trial.conditions.sigma;
    trial.simulator.laser.outliers = trial.conditions.outliers;
    trial.simulator.tour.gives_way_within = kGivesWayWithin;
    Drawer drawer(sites[trial.site], parameters, trial.conditions, random);
    if (!drawer.build(trial.simulator)) continue;
    if (trial.conditions.kidnapped) {
      trial.kidnapped_to = trial.simulator;
      if (!drawer.carry_away(*trial.kidnapped_to)) continue;
    }
    return trial;
  }
}

}  // namespace perceptor
