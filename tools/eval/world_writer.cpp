#include "tools/eval/world_writer.hpp"

#include <cmath>
#include <fstream>
#include <stdexcept>
#include <utility>

#include <nlohmann/json.hpp>

#include "common/floorplan/floorplan_writer.hpp"

namespace perceptor {
namespace {

using Json = nlohmann::ordered_json;

Json place(const Vector2& location) {
  return {{"x", to_millimetres(location.x())}, {"y", to_millimetres(location.y())}};
}

Json pose(const Position& pose) {
  Json json = place(pose.location());
  json["a"] = to_millimetres(pose.a);
  return json;
}

Floorplan map_of(const RandomWorld& world) {
  FloorplanBuilder map;
  for (const Segment& wall : walls(world.rooms)) map.add_wall(wall);
  for (const Furniture& cabinet : world.cabinets) map.add_cabinet(sides(cabinet));
  for (const Doorway& doorway : world.rooms.doorways) map.add_door(doorway.face);
  return map.plan();
}

Json boxes_of(const RandomWorld& world) {
  Json boxes = Json::array();
  for (const Furniture& furniture : world.boxes) {
    Json box = pose(furniture.in_world);
    box["length"] = to_millimetres(furniture.length);
    box["width"] = to_millimetres(furniture.width);
    boxes.push_back(box);
  }
  return boxes;
}

Json people_of(const RandomWorld& world) {
  Json people = Json::array();
  for (const Walker& walker : world.people)
    people.push_back({{"path", {place(walker.path.a), place(walker.path.b)}},
                      {"speed", to_millimetres(walker.speed)},
                      {"waits_within", kWaitsWithin}});
  return people;
}

Json tour_of(const RandomWorld& world) {
  Json tour = Json::array();
  for (const TourStop& stop : world.tour) {
    Json point = place(stop.location);
    if (stop.turn != 0.0) point["turn"] = to_millimetres(stop.turn);
    tour.push_back(point);
  }
  return tour;
}

Json world_of(const RandomWorld& world, const RandomWorldParameters& parameters, std::size_t number,
              const std::string& name) {
  constexpr double kWalkShare = 0.2;  // scatter beside the scale, as worn wheels have
  return {{"_comment", "Random world " + std::to_string(number) + " of seed " +
                           std::to_string(parameters.seed)},
          {"map", "../maps/" + name + ".json"},
          {"seed", number + 1},
          {"start", pose(world.start_in_world)},
          {"odometry",
           {{"start_in_odometry", pose(world.start_in_odometry)},
            {"slip_scale", parameters.slip},
            {"slip_walk", to_millimetres(kWalkShare * parameters.slip)},
            {"slip_turn_walk", to_millimetres(kWalkShare * parameters.slip)}}},
          {"laser", {{"noise_sigma", parameters.sigma}, {"outliers", parameters.outliers}}},
          {"boxes", boxes_of(world)},
          {"people", people_of(world)},
          {"driver", {{"gives_way_within", kGivesWayWithin}}},
          {"tour", tour_of(world)}};
}

/// Each key on a line, each item of a list too.
void write(const Json& document, const std::filesystem::path& file) {
  std::filesystem::create_directories(file.parent_path());
  std::ofstream out(file);
  out << "{\n";
  std::size_t left = document.size();
  for (const auto& [key, value] : document.items()) {
    out << "  " << Json(key).dump() << ": ";
    if (value.is_array() && !value.empty()) {
      const char* before = "[\n    ";
      for (const Json& item : value) out << std::exchange(before, ",\n    ") << item.dump();
      out << "\n  ]";
    } else {
      out << value.dump();
    }
    out << (--left > 0 ? ",\n" : "\n");
  }
  out << "}\n";
  out.close();
  if (!out) throw std::runtime_error(file.string() + ": cannot be written");
}

}  // namespace

void write_random_world(const RandomWorld& world, const RandomWorldParameters& parameters,
                        std::size_t number, const std::filesystem::path& folder,
                        const std::string& name) {
  write_floorplan(map_of(world), "Random world " + std::to_string(number),
                  folder / "maps" / (name + ".json"));
  write(world_of(world, parameters, number, name), folder / "worlds" / (name + ".json"));
}

}  // namespace perceptor
