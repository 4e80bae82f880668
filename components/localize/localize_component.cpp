#include "components/localize/localize_component.hpp"

#include "common/bus/channels.hpp"
#include "common/config/named_file.hpp"
#include "common/floorplan/floorplan.hpp"
#include "common/global_map/global_map.hpp"
#include "common/messages/convert.hpp"
#include "common/time/stamp.hpp"

namespace perceptor {
namespace {

constexpr int kQueue = 200;  // five seconds of scans
constexpr int kGlobalQueue = 4;
constexpr std::string_view kWrongFrame = "not in the robot frame";
constexpr std::string_view kInParts = "in parts";
constexpr std::string_view kIncomplete = "its scan or CURRENT_MAP never came";
constexpr std::string_view kOtherMap = "another map than the one read here";

global_map::GlobalMap read_map(const LocalizeConfig& config) {
  const auto file = config::find_named("map", config.map, config.config_dir / "maps");
  try {
    return global_map::make_global_map(read_floorplan(file));
  } catch (const global_map::TooManyCrossings& error) {
    throw config::Error(file.string() + ": " + error.what());
  }
}

std::optional<localize::StartHint> hint_of(const LocalizeConfig& config, const Map& building) {
  using Start = LocalizeConfig::Start;
  const LocalizeConfig::StartConfig& start = config.start;
  if (start.from == Start::anywhere) return std::nullopt;
  localize::StartHint hint{
      .pose = std::nullopt, .areas = {}, .distance = start.distance, .angle = start.angle};
  if (start.from == Start::pose) hint.pose = start.pose;
  if (start.from == Start::start_area)
    for (const Object& object : building.objects)
      if (object.type == ObjectType::start_area) hint.areas.push_back(corners(building, object));
  if (!hint.pose && hint.areas.empty())
    throw config::Error("/start/from: start_area, but the map " + config.map + " has none");
  return hint;
}

template <class Message>
bool is_before(const Message& message, const pico::map_t& map) {
  return message.session == map.session ? message.seq < map.seq : message.utime < map.utime;
}

template <class Message>
bool is_of(const Message& message, const pico::map_t& map) {
  return message.session == map.session && message.seq == map.seq;
}

/// False where the oldest had to go.
template <class Message>
bool keep(std::deque<Message>& queue, const Message& message, bool began_anew) {
  if (began_anew) queue.clear();
  queue.push_back(message);
  if (queue.size() <= kQueue) return true;
  queue.pop_front();
  return false;
}

/// How the robot moved while the laser swept: as from the map before to this one.
Twist twist_of(const std::optional<pico::map_t>& last, const pico::map_t& map) {
  if (!last || last->zero_utime != map.zero_utime) return {};
  return twist_between(to_model(last->robot_in_zero), to_model(map.robot_in_zero),
                       seconds_between(last->utime, map.utime));
}

pico::world_position_t to_message(const pico::map_t& map, std::int64_t map_id,
                                  const localize::WorldPosition& position) {
  pico::world_position_t message{};
  set_stamp(message, stamp_of(map));
  message.map_id = map_id;
  message.zero_utime = map.zero_utime;
  message.state = static_cast<std::int8_t>(position.state);
  if (position.robot_in_world) {
    message.guessed = position.state == localize::State::tracking ? 0 : 1;
    message.robot_in_world = to_message(position.robot_in_world->pose);
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column)
        message.covariance[3 * row + column] = position.robot_in_world->covariance(row, column);
  }
  message.ambiguous = position.ambiguous ? 1 : 0;
  message.places = position.places;
  message.explained = position.explained;
  message.through = position.through;
  return message;
}

}  // namespace

LocalizeComponent::LocalizeComponent(const LocalizeConfig& config, Bus& bus)
    : LocalizeComponent(config, read_map(config), bus) {}

LocalizeComponent::LocalizeComponent(const LocalizeConfig& config,
                                     const global_map::GlobalMap& building, Bus& bus)
    : bus_(bus),
      map_id_(building.id),
      combined_period_(config.combined_period),
      world_(building.map),
      localizer_(world_, config.localize, hint_of(config, building.map),
                 [this] { bus_.check_what_came(); }),
      combined_(world_, building.map, config.localize.search.beams, config.combined) {
  bus_.subscribe<pico::laser_scan_t>(
      channel::laser, kQueue,
      [this](const pico::laser_scan_t& scan, bool began_anew) { take_scan(scan, began_anew); });
  bus_.subscribe<pico::map_t>(
      channel::current_map, kQueue,
      [this](const pico::map_t& map, bool began_anew) { take_current_map(map, began_anew); });
  bus_.subscribe<pico::map_t>(
      channel::local_map, kQueue,
      [this](const pico::map_t& map, bool began_anew) { take_local_map(map, began_anew); });
  bus_.subscribe<pico::map_t>(channel::global_map, kGlobalQueue,
                              [this](const pico::map_t& map, bool) { check_id(map); });
}

void LocalizeComponent::take_scan(const pico::laser_scan_t& scan, bool began_anew) {
  keep(scans_, scan, began_anew);
  settle();
}

void LocalizeComponent::take_current_map(const pico::map_t& map, bool began_anew) {
  if (!is_whole(channel::current_map, map)) return;
  keep(currents_, map, began_anew);
  settle();
}

void LocalizeComponent::take_local_map(const pico::map_t& map, bool began_anew) {
  if (!is_whole(channel::local_map, map)) return;
  if (!keep(maps_, map, began_anew)) bus_.reject(channel::local_map, kIncomplete);
  settle();
}

bool LocalizeComponent::is_whole(const std::string& channel, const pico::map_t& map) {
  const bool is_in_frame = map.frame == "robot";
  if (!is_in_frame || map.parts != 1) bus_.reject(channel, is_in_frame ? kInParts : kWrongFrame);
  return is_in_frame && map.parts == 1;
}

/// Puts together what has come of one scan, in the order of the local maps. What came before the
/// next of these has none.
void LocalizeComponent::settle() {
  while (!maps_.empty()) {
    const pico::map_t& map = maps_.front();
    const auto is_earlier = [&](const auto& message) { return is_before(message, map); };
    std::erase_if(scans_, is_earlier);
    std::erase_if(currents_, is_earlier);
    if (scans_.empty() || currents_.empty()) return;
    if (is_of(scans_.front(), map) && is_of(currents_.front(), map))
      locate(scans_.front(), currents_.front(), map);
    else
      bus_.reject(channel::local_map, kIncomplete);
    maps_.pop_front();
  }
}

void LocalizeComponent::locate(const pico::laser_scan_t& scan, const pico::map_t& current,
                               const pico::map_t& map) {
  const bool is_same_frame = last_map_ && last_map_->session == map.session &&
                             last_map_->zero_utime == map.zero_utime &&
                             last_map_->utime < map.utime;
  if (!is_same_frame) {
    localizer_.clear();
    last_map_.reset();
    combined_at_.reset();
  }
  localize::Sight sight;
  sight.utime = map.utime;
  sight.robot_in_local = to_model(map.robot_in_local);
  sight.walls = to_model(map);
  sight.scan_walls = to_model(current);
  sight.ends = beam_ends(to_model(scan), twist_of(last_map_, map));
  last_map_ = map;
  last_map_->points.clear();
  last_map_->objects.clear();
  const localize::WorldPosition position = localizer_.update(sight);
  bus_.publish(channel::world_position, to_message(map, map_id_, position));
  combine(position, sight, map.session);
}

void LocalizeComponent::combine(const localize::WorldPosition& position,
                                const localize::Sight& sight, std::int64_t session) {
  const bool is_tracking = position.state == localize::State::tracking && position.robot_in_world;
  if (is_tracking) combined_.add(*position.robot_in_world, sight.ends, sight.utime);
  if (was_tracking_ && !is_tracking) combined_.clear();
  was_tracking_ = is_tracking;
  if (combined_at_ && seconds_between(*combined_at_, sight.utime) < combined_period_) return;
  combined_at_ = sight.utime;
  for (pico::map_t& part : make_map_messages("world", combined_.map(sight.utime), map_id_)) {
    set_stamp(part, {sight.utime + part.part, session, combined_maps_++});
    bus_.publish(channel::combined_map, part);
  }
}

void LocalizeComponent::check_id(const pico::map_t& global_map) {
  if (global_map.map_id != map_id_) bus_.reject(channel::global_map, kOtherMap);
}

}  // namespace perceptor
