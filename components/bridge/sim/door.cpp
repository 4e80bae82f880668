#include "components/bridge/sim/door.hpp"

#include <algorithm>
#include <cmath>

namespace perceptor::sim {

Door::Door(const DoorParameters& parameters)
    : parameters_(parameters), open_ratio_(parameters.mode == DoorMode::open ? 1.0 : 0.0) {}

bool Door::request(double time) {
  if (parameters_.mode != DoorMode::on_request) return false;
  requested_at_ = time;
  return true;
}

bool Door::wants_open(double time) const {
  switch (parameters_.mode) {
    case DoorMode::open:
      return true;
    case DoorMode::on_request:
      return requested_at_ && time - *requested_at_ < parameters_.open_for;
    case DoorMode::timed:
      return std::fmod(time, parameters_.period) < parameters_.open_for;
    case DoorMode::shut:
    case DoorMode::recessed:
      break;
  }
  return false;
}

void Door::advance(double time, double seconds, bool occupied) {
  const double step = seconds / parameters_.travel_time;
  if (wants_open(time)) {
    open_ratio_ = std::min(1.0, open_ratio_ + step);
  } else if (!occupied) {
    open_ratio_ = std::max(0.0, open_ratio_ - step);
  }
}

std::optional<Segment> Door::leaf() const {
  if (open_ratio_ >= 1.0) return std::nullopt;
  const Segment& opening = parameters_.opening;
  const double recess = parameters_.mode == DoorMode::recessed ? parameters_.recess : 0.0;
  const Vector2 set_back = perpendicular(direction(opening)) * recess;
  const Vector2 leading_edge = opening.a + open_ratio_ * (opening.b - opening.a);
  return Segment{leading_edge + set_back, opening.b + set_back};
}

}  // namespace perceptor::sim
