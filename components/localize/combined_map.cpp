#include "components/localize/combined_map.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "common/geometry/angle.hpp"
#include "common/time/stamp.hpp"

namespace perceptor::localize {
namespace {

constexpr std::int32_t kDoorIds = 100'000;  // above all ids of walls
constexpr std::int32_t kObjectIds = 200'000;

double square(double value) { return value * value; }

Object obstacle(Map& map, const UnknownObject& seen) {
  Object object;
  object.id = kObjectIds + seen.id;
  object.name = (seen.is_static ? "static " : "dynamic ") + std::to_string(seen.id);
  object.type = seen.is_static ? ObjectType::static_obstacle : ObjectType::dynamic_obstacle;
  object.connection = Connection::closed;
  object.colour = seen.is_static ? 0xCC6600 : 0xCC3399;
  object.is_new = false;
  object.weight = seen.weight;
  object.first_seen = seen.first_seen;
  object.last_seen = seen.last_seen;
  object.reason = "not on the map";
  const auto index = static_cast<Index>(map.objects.size());
  for (const Vector2& corner : seen.outline) {
    const Index point = add_point(map, corner);
    map.points[static_cast<std::size_t>(point)].parents = {index};
    object.points.push_back(point);
  }
  return object;
}

}  // namespace

CombinedMap::CombinedMap(const World& world, Map global_map, const BeamFitParameters& fit,
                         const CombinedMapParameters& parameters)
    : world_(world),
      global_map_(std::move(global_map)),
      fit_(fit),
      parameters_(parameters),
      objects_on_map_(global_map_.objects.size()),
      doors_(world.doorways().size()),
      objects_(parameters.objects) {
  set_objects_old(global_map_);
}

void CombinedMap::clear() {
  objects_on_map_.assign(objects_on_map_.size(), {});
  doors_.assign(doors_.size(), {});
  objects_.clear();
  checked_.reset();
}

void CombinedMap::add(const PoseEstimate& robot_in_world, const std::vector<BeamEnd>& ends,
                      std::int64_t utime) {
  if (!is_trusted(robot_in_world, ends, utime)) return;
  std::vector<WorldBeam> beams;
  std::vector<bool> unknown;
  const Position turn{0.0, 0.0, robot_in_world.pose.a};
  for (const Beam& beam : choose_beams(ends, parameters_.beams)) {
    const WorldBeam seen{transform(robot_in_world.pose, beam.origin),
                         transform(turn, beam.direction), beam.range};
    const RayHit met = world_.meet_face(seen.origin, seen.direction);
    watch_face(seen, met, utime);
    bool ends_in_door = false;
    for (std::size_t i = 0; i < doors_.size(); ++i)
      ends_in_door = watch_door(seen, i, utime) || ends_in_door;
    beams.push_back(seen);
    unknown.push_back(!ends_in_door && is_unknown(seen, met));
  }
  for (DoorState& door : doors_) decide(door, utime);
  objects_.add(beams, unknown, utime);
}

bool CombinedMap::is_trusted(const PoseEstimate& robot_in_world, const std::vector<BeamEnd>& ends,
                             std::int64_t utime) {
  const Eigen::Matrix3d& covariance = robot_in_world.covariance;
  const bool is_certain = covariance(0, 0) + covariance(1, 1) < square(parameters_.max_sigma) &&
                          covariance(2, 2) < square(parameters_.max_angle);
  if (!is_certain) return false;
  const bool is_due = !checked_ || seconds_between(*checked_, utime) >= parameters_.check_period;
  if (is_due) {
    trusted_ = fits_best(robot_in_world.pose, choose_beams(ends, fit_.beams));
    checked_ = utime;
  }
  return trusted_;
}

bool CombinedMap::fits_best(const Position& robot_in_world, const std::vector<Beam>& beams) const {
  const auto rate = [&](const Position& pose) {
    return fit_beams(world_, pose, beams, fit_).log_likelihood;
  };
  const double here = rate(robot_in_world);
  const double aside = parameters_.beside;
  const double askew = parameters_.askew;
  const auto is_better = [&](const Position& move) {
    return rate(compose(robot_in_world, move)) > here;
  };
  return std::ranges::none_of(std::initializer_list<Position>{{aside, 0.0, 0.0},
                                                              {-aside, 0.0, 0.0},
                                                              {0.0, aside, 0.0},
                                                              {0.0, -aside, 0.0},
                                                              {0.0, 0.0, askew},
                                                              {0.0, 0.0, -askew},
                                                              {0.0, 0.0, 2.0 * askew},
                                                              {0.0, 0.0, -2.0 * askew}},
                              is_better);
}

void CombinedMap::watch_face(const WorldBeam& beam, const RayHit& met, std::int64_t utime) {
  if (std::isinf(met.distance)) return;
  const Face& face = world_.faces()[met.line];
  if (std::abs(beam.direction.dot(face.line.normal)) < parameters_.min_incidence) return;
  Presence& presence = objects_on_map_[face.object];
  const double beyond = beam.range - met.distance;
  if (std::abs(beyond) < parameters_.tolerance)
    presence.balance = std::min(parameters_.most_wall, presence.balance + 1.0);
  else if (beyond > parameters_.through)
    presence.balance = std::max(-parameters_.most_wall, presence.balance - 1.0);
  else
    return;
  presence.last_seen = utime;
}

/// Whether the beam ends where a leaf may stand.
bool CombinedMap::watch_door(const WorldBeam& beam, std::size_t doorway, std::int64_t utime) {
  const Doorway& way = world_.doorways()[doorway];
  const Vector2 along = direction(way.opening);
  const Vector2 from_middle = beam.origin - middle(way.opening);
  const Vector2 end = from_middle + beam.range * beam.direction;
  const double half = length(way.opening) / 2.0;
  const double leaf = way.half_depth + parameters_.leaf;
  const double depth = cross(along, end);
  const bool ends_there = std::abs(depth) < leaf && std::abs(along.dot(end)) < half;

  const double towards = cross(along, beam.direction);
  const double to_opening = -cross(along, from_middle) / towards;
  const double crossing = along.dot(from_middle) + to_opening * along.dot(beam.direction);
  const double middle = parameters_.door_middle * half;
  const bool passes = to_opening > 0.0 && beam.range > to_opening && std::abs(depth) >= leaf &&
                      std::abs(crossing) < middle;
  const bool tells = std::abs(towards) > parameters_.min_incidence &&
                     (passes || (ends_there && std::abs(along.dot(end)) < middle));
  if (!tells) return ends_there;
  DoorState& door = doors_[doorway];
  const double fading = std::exp(-seconds_between(door.faded, utime) / parameters_.door_memory);
  door.open *= fading;
  door.shut *= fading;
  door.faded = utime;
  (passes ? door.open : door.shut) += 1.0;
  return ends_there;
}

void CombinedMap::decide(DoorState& door, std::int64_t utime) const {
  const double told = door.open + door.shut;
  if (door.faded != utime || told < parameters_.door) return;
  door.is_open = door.open > door.shut;
  door.confidence = std::max(door.open, door.shut) / told;
  door.last_seen = utime;
}

bool CombinedMap::is_unknown(const WorldBeam& beam, const RayHit& met) const {
  if (beam.range > parameters_.max_range) return false;
  if (std::isinf(met.distance) || beam.range > met.distance - parameters_.tolerance) return false;
  const Vector2 end = beam.origin + beam.range * beam.direction;
  const auto is_near = [&](const Face& face) {
    return distance(face.segment, end) < parameters_.tolerance;
  };
  return std::ranges::none_of(world_.faces(), is_near);
}

void CombinedMap::describe_wall(Object& wall, const Presence& presence) const {
  wall.weight = std::abs(presence.balance);
  wall.last_seen = presence.last_seen;
  wall.reason = "unseen";
  if (presence.balance >= parameters_.wall) wall.reason = "confirmed";
  if (presence.balance <= -parameters_.wall) wall.reason = "contradicted";
}

Map CombinedMap::map(std::int64_t utime) {
  Map map = global_map_;
  for (std::size_t i = 0; i < map.objects.size(); ++i) {
    Object& object = map.objects[i];
    if (object.type == ObjectType::wall || object.type == ObjectType::cabinet)
      describe_wall(object, objects_on_map_[i]);
    object.remove = object.type == ObjectType::door;  // drawn ones are among the doorways
  }
  remove_objects(map);
  for (std::size_t i = 0; i < doors_.size(); ++i) {
    const auto number = static_cast<std::int32_t>(i);
    const Index index = add_segment(map, world_.doorways()[i].opening, ObjectType::door,
                                    "door " + std::to_string(i));
    Object& door = map.objects[static_cast<std::size_t>(index)];
    const DoorState& state = doors_[i];
    door.id = kDoorIds + number;
    door.is_new = false;
    door.reason = !state.is_open ? "unseen" : *state.is_open ? "open" : "shut";
    door.confidence = state.confidence;
    door.last_seen = state.last_seen;
    door.colour = !state.is_open ? 0x808080 : *state.is_open ? 0x009E73 : 0xD55E00;
  }
  for (const UnknownObject& seen : objects_.objects(utime)) {
    Object object = obstacle(map, seen);
    map.objects.push_back(std::move(object));
  }
  return map;
}

}  // namespace perceptor::localize
