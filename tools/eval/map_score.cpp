#include "tools/eval/map_score.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include <pico/laser_scan_t.hpp>

#include "common/bus/bus.hpp"
#include "common/bus/channels.hpp"
#include "common/messages/convert.hpp"
#include "common/time/stamp.hpp"

namespace perceptor {
namespace {

constexpr std::size_t kKept = 400;  // ten seconds of scans: truth and map stand closer

std::int64_t microseconds(double seconds) {
  return std::llround(seconds * static_cast<double>(kMicrosecondsPerSecond));
}

/// Puts the objects of one map behind those of another.
void append(const Map& part, Map& whole) {
  const auto offset = static_cast<Index>(whole.points.size());
  whole.points.insert(whole.points.end(), part.points.begin(), part.points.end());
  for (Object object : part.objects) {
    for (Index& point : object.points) point += offset;
    whole.objects.push_back(std::move(object));
  }
}

std::vector<Segment> segments_of(const TrueWorld& world) {
  std::vector<Segment> segments;
  for (const TrueSide& side : world.sides) segments.push_back(side.segment);
  return segments;
}

std::vector<Segment> doors_of(const Map& map) {
  std::vector<Segment> doors;
  for (const Object& object : map.objects)
    if (object.type == ObjectType::door && object.points.size() == 2)
      doors.push_back(segment(map, object));
  return doors;
}

template <class Message, class Take>
void decode(const LogEvent& event, const Take& take) {
  if (Message message; detail::decode(event.data, message).empty()) take(message);
}

std::string covered(const SeenSide& seen, double share, std::int64_t utime) {
  char text[96];
  std::snprintf(text, sizeof text, "%2.0f %% covered, seen for %.1f s", 100.0 * share,
                seconds_between(seen.since, utime));
  return text;
}

}  // namespace

MapScorer::MapScorer(const MapScoreParameters& parameters, Sink sink)
    : parameters_(parameters),
      sink_(std::move(sink)),
      doors_(parameters.doors),
      seen_(parameters.seen) {}

void MapScorer::take(const LogEvent& event) {
  if (event.channel == channel::laser) {
    if (!fan_)
      decode<pico::laser_scan_t>(event, [&](const pico::laser_scan_t& scan) {
        fan_ = {static_cast<std::size_t>(scan.num_ranges), scan.angle_min, scan.angle_increment,
                std::min(scan.valid_max, parameters_.max_reach)};
        laser_in_robot_ = to_model(scan.laser_in_robot);
      });
  } else if (event.channel == channel::world) {
    decode<pico::map_t>(event, [&](const pico::map_t& part) { take_world(part); });
  } else if (event.channel == channel::truth) {
    decode<pico::truth_t>(event, [&](const pico::truth_t& truth) { take_truth(truth); });
  } else if (event.channel == channel::local_map || event.channel == channel::identified_map) {
    decode<pico::map_t>(event, [&](const pico::map_t& map) {
      take_map(map, event.channel == channel::identified_map);
    });
  }
}

void MapScorer::take_world(const pico::map_t& part) {
  if (part.part == 0) world_parts_ = {};
  append(to_model(part), world_parts_);
  if (part.part + 1 == part.parts) world_ = true_world(world_parts_, parameters_.world);
}

void MapScorer::begin_session(const pico::truth_t& truth) {
  session_ = truth.session;
  first_utime_ = truth.utime;
  next_local_ = next_identified_ = truth.utime + microseconds(parameters_.skipped);
  seen_.clear();
  doors_.begin_anew();
}

void MapScorer::take_truth(const pico::truth_t& truth) {
  if (first_utime_ == 0 || truth.session != session_) begin_session(truth);
  const Position robot_in_world = to_model(truth.robot_in_world);
  if (fan_ && fan_->angle_increment > 0.0 && !world_.sides.empty()) {
    std::vector<Body> bodies;
    for (const pico::mover_truth_t& mover : truth.movers)
      bodies.push_back({{mover.x, mover.y}, mover.radius});
    const Position laser_in_world = compose(robot_in_world, laser_in_robot_);
    const std::vector<SideView> views =
        side_views(cast_beams(world_, bodies, laser_in_world, *fan_), world_.sides.size(),
                   parameters_.max_beam_gap);
    seen_.take(truth.utime, world_, views, laser_in_world.location());
    doors_.take_view(truth.utime, world_, views, robot_in_world.location());
  }
  poses_.push_back({truth.session, truth.seq, robot_in_world});
  if (poses_.size() > kKept) poses_.pop_front();

  std::deque<Waiting> waiting;
  waiting.swap(early_);
  for (const Waiting& one : waiting) take_map(one.map, one.is_identified);
}

void MapScorer::take_map(const pico::map_t& map, bool is_identified) {
  const auto pose = std::ranges::find_if(poses_.rbegin(), poses_.rend(), [&](const Pose& p) {
    return p.session == map.session && p.seq == map.seq;
  });
  if (pose == poses_.rend()) {
    early_.push_back({map, is_identified});
    if (early_.size() > kKept) early_.pop_front();
  } else if (!world_.sides.empty()) {
    is_identified ? score_identified(map, pose->robot_in_world)
                  : score_local(map, pose->robot_in_world);
  }
}

bool MapScorer::is_due(std::int64_t utime, std::int64_t& next) const {
  if (utime < next) return false;
  while (next <= utime) next += microseconds(parameters_.period);
  return true;
}

void MapScorer::tell(std::int64_t utime, const char* what, const Segment& where,
                     const std::string& more) {
  if (!sink_) return;
  char text[256];
  std::snprintf(text, sizeof text, "%7.2f s  %-14s (%.2f, %.2f) to (%.2f, %.2f)  %s",
                seconds_between(first_utime_, utime), what, where.a.x(), where.a.y(), where.b.x(),
                where.b.y(), more.c_str());
  sink_(text);
}

void MapScorer::score_local(const pico::map_t& message, const Position& robot_in_world) {
  if (!is_due(message.utime, next_local_)) return;
  const Map map = transform(to_model(message), robot_in_world);
  const std::vector<Segment> true_segments = segments_of(world_);
  ++score_.maps;
  std::vector<MapWall> walls;
  for (const Object* wall : walls_of(map)) {
    walls.push_back({segment(map, *wall), wall->free_side});
    const Segment& found = walls.back().segment;
    const bool is_right = is_on_a_wall(found, true_segments, parameters_.on_a_wall);
    score_.right += {is_right ? 1 : 0, 1};
    if (!is_right) tell(message.utime, "no such wall", found, "id " + std::to_string(wall->id));
  }
  const WallRecall recall = wall_recall(walls, world_, seen_, parameters_.recall);
  score_.walls += recall.walls;
  score_.furniture += recall.furniture;
  for (const MissedSide& missed : recall.missed)
    tell(message.utime,
         world_.sides[missed.side].surface == Surface::wall ? "wall missed" : "side missed",
         world_.sides[missed.side].segment,
         covered(seen_.seen(missed.side, missed.from), missed.covered, message.utime));
  const std::size_t doubles = count_double_walls(map, message.utime, parameters_.doubles);
  score_.doubles += static_cast<std::int64_t>(doubles);
  if (doubles > 0)
    tell(message.utime, "doubles", {robot_in_world.location(), robot_in_world.location()},
         std::to_string(doubles));
}

void MapScorer::score_identified(const pico::map_t& message, const Position& robot_in_world) {
  const bool is_counted = is_due(message.utime, next_identified_);
  const Map map = transform(to_model(message), robot_in_world);
  const std::vector<Segment> doors = doors_of(map);
  const Vector2 robot = robot_in_world.location();
  const auto missing = doors_.take_doors(message.utime, world_, doors, robot, is_counted);
  if (!is_counted) return;
  for (const WrongCorner& wrong :
       score_corners(map, world_, seen_, parameters_.corners, score_.corners))
    tell(message.utime, wrong.fault == CornerFault::none_there ? "no such corner" : "corner's type",
         {wrong.location, wrong.location}, "");
  for (const TrueOpening* opening : missing)
    tell(message.utime, "door missed", opening->faces.front().segment, "");
  for (const Segment& door : doors)
    if (!doors_.is_right(world_, door, robot).value_or(true))
      tell(message.utime, "no such door", door, "");
}

MapScore MapScorer::score() const {
  MapScore score = score_;
  score.doors = doors_.score();
  return score;
}

}  // namespace perceptor
