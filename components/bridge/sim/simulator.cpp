#include "components/bridge/sim/simulator.hpp"

#include <algorithm>
#include <cmath>

#include "common/time/stamp.hpp"

namespace perceptor::sim {
namespace {

/// The time of event number `count` of a regular sequence. Each is computed from the start, so
/// that rounding does not add up.
std::int64_t time_of(std::int64_t start, std::int64_t count, double rate) {
  const double microseconds = static_cast<double>(count) * 1e6 / rate;
  return start + std::llround(microseconds);
}

/// From the first beam to the last, rounded up [us].
std::int64_t sweep_time(const LaserParameters& laser) {
  return static_cast<std::int64_t>(std::ceil(laser.sweep_time * 1e6));
}

std::int64_t completion(const Measurement& measurement) {
  if (const auto* sweep = std::get_if<Sweep>(&measurement)) return sweep->completed;
  return std::get<OdometryReading>(measurement).utime;
}

}  // namespace

Simulator::Simulator(const SimulatorParameters& parameters)
    : parameters_(parameters),
      utime_(parameters.start_utime),
      base_(parameters.base, parameters.start_in_world),
      odometry_(parameters.odometry, static_cast<std::uint64_t>(parameters.seed)),
      laser_(parameters.laser, static_cast<std::uint64_t>(parameters.seed)),
      tour_driver_(parameters.tour),
      command_(parameters.command_lifetime) {
  const World& world = parameters_.world;
  Random gait = make_stream(static_cast<std::uint64_t>(parameters.seed), Stream::gait);
  for (const DoorParameters& door : world.doors) doors_.emplace_back(door);
  for (const PersonParameters& person : world.people) people_.emplace_back(person, gait);

  auto& fixed = obstacles_.segments;
  fixed = world.walls;
  fixed.insert(fixed.end(), world.cabinets.begin(), world.cabinets.end());
  for (const Box& box : world.boxes)
    for (const Segment& edge : edges(outline(box))) fixed.push_back(edge);
  fixed_segments_ = fixed.size();
}

double Simulator::seconds_since_start() const {
  return seconds_between(parameters_.start_utime, utime_);
}

std::int64_t Simulator::next_odometry() const {
  return time_of(parameters_.start_utime, readings_, parameters_.odometry.rate);
}

std::int64_t Simulator::next_sweep() const {
  return time_of(parameters_.start_utime, sweeps_, parameters_.laser.rate);
}

std::int64_t Simulator::next_due() const {
  const std::int64_t next = std::min(next_odometry(), next_sweep() + sweep_time(parameters_.laser));
  const std::int64_t ticks = (next - utime_ + parameters_.tick - 1) / parameters_.tick;
  return utime_ + (std::max<std::int64_t>(ticks, 1) * parameters_.tick);
}

void Simulator::command(const Twist& wished, std::optional<std::int64_t> measured_at) {
  command_.take(wished, std::min(measured_at.value_or(utime_), utime_));
}

bool Simulator::request_door(std::optional<int> door) {
  if (door) {
    const auto index = static_cast<std::size_t>(*door);
    return *door >= 0 && index < doors_.size() && doors_[index].request(seconds_since_start());
  }
  Door* nearest = nullptr;
  double nearest_distance = 0.0;
  for (Door& candidate : doors_) {
    if (candidate.parameters().mode != DoorMode::on_request) continue;
    const double away = distance(candidate.parameters().opening, base_.robot_in_world().location());
    if (nearest != nullptr && away >= nearest_distance) continue;
    nearest = &candidate;
    nearest_distance = away;
  }
  return nearest != nullptr && nearest->request(seconds_since_start());
}

Twist Simulator::wished_twist(double seconds) {
  const bool is_commanded = parameters_.drive == Drive::command ||
                            (parameters_.drive == Drive::automatic && command_.has_come());
  if (!is_commanded) {
    const Twist wished = tour_driver_.drive(base_.robot_in_world(), seconds, obstacles_.bodies);
    if (const auto door = tour_driver_.take_door_request()) request_door(*door);
    return wished;
  }
  return command_.at(utime_).value_or(Twist{});
}

void Simulator::move_world(double seconds) {
  obstacles_.segments.resize(fixed_segments_);
  obstacles_.bodies.clear();
  obstacles_.legs.clear();
  for (Door& door : doors_) {
    door.advance(seconds_since_start(), seconds, base_.would_touch(door.parameters().opening));
    if (const auto leaf = door.leaf()) obstacles_.segments.push_back(*leaf);
  }
  for (Person& person : people_) {
    person.advance(seconds, base_.robot_in_world().location());
    obstacles_.bodies.push_back(person.body());
    for (const Circle& leg : person.legs()) obstacles_.legs.push_back(leg);
  }
}

std::vector<Measurement> Simulator::advance() {
  const Tick tick{utime_, utime_ + parameters_.tick, base_.robot_in_world(),
                  odometry_.robot_in_odometry()};
  const double seconds = seconds_between(tick.from, tick.to);

  const Twist wished = wished_twist(seconds);
  move_world(seconds);
  base_.advance(wished, seconds, obstacles_);
  odometry_.advance(relative(tick.robot_in_world_from, base_.robot_in_world()));

  std::vector<Measurement> measured;
  read_wheels(tick, measured);
  sweep(tick, measured);
  std::stable_sort(measured.begin(), measured.end(), [](const auto& first, const auto& second) {
    return completion(first) < completion(second);
  });
  utime_ = tick.to;
  return measured;
}

void Simulator::read_wheels(const Tick& tick, std::vector<Measurement>& measured) {
  for (; next_odometry() <= tick.to; ++readings_) {
    const double fraction =
        seconds_between(tick.from, next_odometry()) / seconds_between(tick.from, tick.to);
    const Position turned =
        interpolate(tick.robot_in_odometry_from, odometry_.robot_in_odometry(), fraction);
    measured.emplace_back(OdometryReading{next_odometry(), odometry_.read(turned)});
  }
}

void Simulator::sweep(const Tick& tick, std::vector<Measurement>& measured) {
  while (true) {
    const std::int64_t begin = next_sweep();
    if (begin >= tick.to) return;
    const Laser::Stretch stretch{seconds_between(begin, tick.from), seconds_between(begin, tick.to),
                                 tick.robot_in_world_from, base_.robot_in_world()};
    if (!sweep_under_way_) {
      const double fraction = -stretch.from / (stretch.to - stretch.from);
      sweep_under_way_ = Sweep{begin, begin + sweep_time(parameters_.laser), {}, truth()};
      sweep_under_way_->truth.robot_in_world =
          interpolate(stretch.robot_in_world_from, stretch.robot_in_world_to, fraction);
    }
    laser_.sweep(stretch, obstacles_);
    if (!laser_.is_complete()) return;
    sweep_under_way_->ranges = laser_.take_ranges();
    measured.emplace_back(std::move(*sweep_under_way_));
    sweep_under_way_.reset();
    ++sweeps_;
  }
}

Truth Simulator::truth() const {
  Truth truth{base_.robot_in_world(), base_.twist(), base_.in_collision(), {}, {}};
  for (const Door& door : doors_)
    truth.doors.push_back({door.parameters().opening, door.open_ratio()});
  for (const Person& person : people_) truth.movers.push_back({person.body(), person.velocity()});
  return truth;
}

}  // namespace perceptor::sim
