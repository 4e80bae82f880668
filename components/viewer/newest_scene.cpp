/// What the newest messages show, layer by layer.
#include <iterator>
#include <utility>

#include "common/bus/channels.hpp"
#include "common/messages/convert.hpp"
#include "common/text/format.hpp"
#include "components/viewer/map_items.hpp"
#include "components/viewer/newest.hpp"
#include "components/viewer/sensor_items.hpp"

namespace perceptor::viewer {
namespace {

Eigen::Matrix2d covariance_of_place(const double (&covariance)[9]) {
  Eigen::Matrix2d place;
  place << covariance[0], covariance[1], covariance[3], covariance[4];
  return place;
}

std::vector<SectorView> sectors_of(const pico::proximity_t& proximity) {
  std::vector<SectorView> sectors;
  for (std::size_t i = 0; i < proximity.distances.size(); ++i)
    sectors.push_back({proximity.too_close[i] != 0, proximity.blind[i] != 0,
                       proximity.contact[i] != 0, proximity.distances[i]});
  return sectors;
}

WayOut way_out_of(const pico::entrance_t& entrance) {
  WayOut way_out;
  way_out.found = entrance.entrance_found != 0;
  way_out.middle = {entrance.middle_x, entrance.middle_y};
  way_out.direction = entrance.direction;
  way_out.width = entrance.width;
  way_out.confidence = entrance.confidence;
  if (entrance.in_hallway != 0)
    way_out.hallway = {{entrance.centre_x1, entrance.centre_y1},
                       {entrance.centre_x2, entrance.centre_y2}};
  way_out.hallway_width = entrance.hallway_width;
  return way_out;
}

void append(std::vector<Item>& items, std::vector<Item> more) {
  items.insert(items.end(), std::make_move_iterator(more.begin()),
               std::make_move_iterator(more.end()));
}

std::string note_of(const pico::world_position_t& position) {
  std::string note = position.state == pico::world_position_t::LOST
                         ? "lost: the place in the building proved wrong, searching again"
                         : "searching for the robot in the building";
  if (position.ambiguous != 0)
    note += format("; %d places explain all that was seen", position.places);
  return note + "; its map is shown when the place is known";
}

}  // namespace

const pico::map_t* Newest::local_map() const {
  const auto found = maps_.find(channel::local_map);
  return found == maps_.end() ? nullptr : &found->second.there.begin()->second;
}

std::vector<Item> Newest::items_of(const std::string& channel,
                                   std::vector<Item> (*items_of_map)(const Map&)) const {
  std::vector<Item> items;
  const auto found = maps_.find(channel);
  if (found == maps_.end()) return items;
  for (const auto& [number, part] : found->second.there) {
    const bool is_in_robot_frame = part.frame == "robot" && channel != channel::current_map;
    const Position map_in_layer = is_in_robot_frame ? to_model(part.robot_in_local) : Position{};
    append(items, items_of_map(transform(to_model(part), map_in_layer)));
  }
  return items;
}

void Newest::add_local_layers(Scene& scene) const {
  const Position local = frames_.local_in_scene();
  scene[Layer::local_map] = {local, items_of(channel::local_map, local_map_items)};
  scene[Layer::identified] = {local, items_of(channel::identified_map, identified_items)};
  scene[Layer::trail].frame_in_scene = local;
  if (trail_.size() > 1)
    scene[Layer::trail].items = {
        {Mark::trail, {trail_.begin(), trail_.end()}, "where the robot has been"}};
}

void Newest::add_sensor_layers(Scene& scene) const {
  const auto robot = [&](const char* channel) {
    const auto utime = clock_.heard(channel);
    return utime ? frames_.robot_in_scene(*utime) : frames_.robot_in_scene();
  };
  if (scan_) scene[Layer::beams] = {robot(channel::laser), beam_items(to_model(*scan_), twist_)};
  scene[Layer::current_map] = {robot(channel::current_map),
                               items_of(channel::current_map, current_map_items)};
  if (proximity_)
    scene[Layer::proximity] = {robot(channel::proximity),
                               proximity_items(sectors_of(*proximity_), proximity_->radius)};
  if (entrance_)
    scene[Layer::way_out] = {robot(channel::entrance), way_out_items(way_out_of(*entrance_))};
}

void Newest::add_world_layers(Scene& scene) const {
  const auto world = frames_.world_in_scene();
  if (!world) return;
  scene[Layer::global_map] = {*world, items_of(channel::global_map, global_map_items)};
  scene[Layer::combined_map] = {*world, items_of(channel::combined_map, combined_map_items)};
  scene[Layer::obstacles] = {*world, items_of(channel::combined_map, obstacle_items)};
}

void Newest::add_true_layer(Scene& scene) const {
  const auto world = frames_.true_world_in_scene();
  if (!truth_ || !world) return;
  LayerScene& layer = scene[Layer::truth];
  layer = {*world, items_of(channel::world, true_world_items)};
  for (const pico::mover_truth_t& mover : truth_->movers)
    layer.items.push_back(
        disc_item(Mark::true_mover, {mover.x, mover.y}, mover.radius, "a person, in truth"));
  layer.items.push_back(
      heading_item(Mark::true_robot, to_model(truth_->robot_in_world), "the robot, in truth"));
}

void Newest::add_robot_layer(Scene& scene) const {
  LayerScene& layer = scene[Layer::robot];
  layer.frame_in_scene = scene.robot_in_scene;
  if (const pico::map_t* map = local_map()) layer.items = robot_items(to_model(*map));
  if (auto ellipse = pose_ellipse()) layer.items.push_back(std::move(*ellipse));
  if (scene.utime > 0) layer.items.push_back(heading_item(Mark::heading, {}, "the robot"));
}

/// In the robot frame.
std::optional<Item> Newest::pose_ellipse() const {
  Position robot;
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
  const pico::map_t* local = local_map();
  if (frames_.frame() == SceneFrame::world && world_position_) {
    robot = to_model(world_position_->robot_in_world);
    covariance = covariance_of_place(world_position_->covariance);
  } else if (local != nullptr) {
    robot = to_model(local->robot_in_local);
    covariance = covariance_of_place(local->robot_in_local_covariance);
  }
  std::optional<Item> ellipse = ellipse_item(robot, covariance);
  if (ellipse)
    for (Vector2& point : ellipse->points) point = transform(inverse(robot), point);
  return ellipse;
}

std::vector<std::string> Newest::notes() const {
  if (!clock_.has_heard_anything() && maps_.empty())
    return {"nothing has come yet: is pico-bridge running, on this bus?"};
  std::vector<std::string> notes = clock_.notes(parameters_.stale);
  if (world_position_ && world_position_->state != pico::world_position_t::TRACKING)
    notes.push_back(note_of(*world_position_));
  return notes;
}

Scene Newest::scene() const {
  Scene scene;
  scene.frame = frames_.frame();
  scene.utime = clock_.now();
  scene.robot_in_scene = frames_.robot_in_scene();
  add_world_layers(scene);
  add_sensor_layers(scene);
  add_true_layer(scene);
  add_local_layers(scene);
  add_robot_layer(scene);
  scene.notes = notes();
  return scene;
}

}  // namespace perceptor::viewer
