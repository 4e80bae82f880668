#include "components/identify/entrance_tracker.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "common/geometry/angle.hpp"
#include "common/time/stamp.hpp"

namespace perceptor::identify {
namespace {

double median(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

template <class Part>
double median_of(const std::vector<Exit>& exits, Part part) {
  std::vector<double> values;
  values.reserve(exits.size());
  for (const Exit& exit : exits) values.push_back(part(exit));
  return median(std::move(values));
}

/// Part by part. Directions are counted from the first one's, which all are near to.
Exit median_exit(const std::vector<Exit>& exits) {
  const double reference = exits.front().direction;
  const double turn =
      median_of(exits, [&](const Exit& e) { return angle_difference(reference, e.direction); });
  return {.middle = {median_of(exits, [](const Exit& e) { return e.middle.x(); }),
                     median_of(exits, [](const Exit& e) { return e.middle.y(); })},
          .direction = wrap_angle(reference + turn),
          .width = median_of(exits, [](const Exit& e) { return e.width; }),
          .confidence = median_of(exits, [](const Exit& e) { return e.confidence; })};
}

double turn_between(const Exit& a, const Exit& b) {
  return std::abs(angle_difference(a.direction, b.direction));
}

/// Whether both can be one opening. The two sides of it lead different ways.
bool is_same(const Exit& a, const Exit& b, double same_opening) {
  constexpr double kQuarterTurn = 0.5 * std::numbers::pi;
  return distance(a.middle, b.middle) <= same_opening && turn_between(a, b) < kQuarterTurn;
}

/// Whether the robot, at the origin, is still on the inner side.
bool leads_away(const Exit& in_robot) {
  const Vector2 outward(std::cos(in_robot.direction), std::sin(in_robot.direction));
  return outward.dot(in_robot.middle) > 0.0;
}

/// What several scans saw of one opening, the last one first.
struct Seen {
  std::vector<Exit> sightings;
  std::size_t last_scan = 0;  ///< that a sighting was taken from
};

}  // namespace

void EntranceTracker::clear() {
  scans_.clear();
  named_.reset();
}

std::optional<Exit> EntranceTracker::update(std::int64_t utime, const Position& robot_in_local,
                                            const std::vector<Exit>& exits) {
  Scan scan{utime, {}};
  for (const Exit& exit : exits) scan.exits.push_back(transform(robot_in_local, exit));
  remember(std::move(scan));

  std::optional<Exit> best;
  std::optional<Exit> best_in_local;
  double best_worth = 0.0;
  for (const std::vector<Exit>& sightings : openings()) {
    const std::optional<Exit> in_local = agreed(sightings);
    if (!in_local || in_local->confidence < parameters_.min_confidence) continue;
    const Exit in_robot = transform(inverse(robot_in_local), *in_local);
    const bool is_near = length(in_robot.middle) <= parameters_.max_distance;
    if (!is_near || !leads_away(in_robot)) continue;
    const double its_worth = worth(*in_local, in_robot);
    if (best && its_worth <= best_worth) continue;
    best = in_robot;
    best_in_local = in_local;
    best_worth = its_worth;
  }
  named_ = best_in_local;
  return best;
}

void EntranceTracker::remember(Scan scan) {
  scans_.push_back(std::move(scan));
  const auto is_old = [this](const Scan& s) {
    return seconds_between(s.utime, scans_.back().utime) > parameters_.max_age;
  };
  const auto kept = static_cast<std::size_t>(std::max(parameters_.scans, 1));
  while (scans_.size() > kept || is_old(scans_.front())) scans_.pop_front();
}

/// Counted of all scans that could be there, so that the first few never decide.
std::size_t EntranceTracker::needed() const {
  constexpr double kRounding = 1e-9;  // 0.6 times 15 is 9
  const double share = parameters_.min_share * parameters_.scans;
  return static_cast<std::size_t>(std::max(1.0, std::ceil(share - kRounding)));
}

/// The sightings of each opening that enough scans can have seen.
std::vector<std::vector<Exit>> EntranceTracker::openings() const {
  std::vector<Seen> found;
  for (std::size_t scan = scans_.size(); scan-- > 0;) {
    const bool may_begin = scan + 1 >= needed();
    for (const Exit& exit : scans_[scan].exits) {
      Seen* nearest = nullptr;
      for (Seen& opening : found) {
        const Exit& newest = opening.sightings.front();
        const bool has_it_already = opening.last_scan == scan;
        if (has_it_already || !is_same(newest, exit, parameters_.same_opening)) continue;
        const bool is_nearer =
            nearest == nullptr || distance(newest.middle, exit.middle) <
                                      distance(nearest->sightings.front().middle, exit.middle);
        if (is_nearer) nearest = &opening;
      }
      if (nearest != nullptr) {
        nearest->sightings.push_back(exit);
        nearest->last_scan = scan;
      } else if (may_begin) {
        found.push_back({{exit}, scan});
      }
    }
  }
  std::vector<std::vector<Exit>> all;
  all.reserve(found.size());
  for (Seen& opening : found) all.push_back(std::move(opening.sightings));
  return all;
}

/// The median of the sightings, if enough of them agree with it.
std::optional<Exit> EntranceTracker::agreed(const std::vector<Exit>& sightings) const {
  if (sightings.size() < needed()) return std::nullopt;
  const Exit typical = median_exit(sightings);
  const auto agrees = [&](const Exit& exit) {
    return distance(exit.middle, typical.middle) <= parameters_.max_scatter &&
           std::abs(exit.width - typical.width) <= parameters_.max_scatter &&
           turn_between(exit, typical) <= parameters_.max_turn;
  };
  const auto agreeing = static_cast<std::size_t>(std::ranges::count_if(sightings, agrees));
  return agreeing >= needed() ? std::optional(typical) : std::nullopt;
}

double EntranceTracker::worth(const Exit& in_local, const Exit& in_robot) const {
  const double far = length(in_robot.middle) / parameters_.half_distance;
  const bool was_named = named_ && is_same(*named_, in_local, parameters_.same_opening);
  return in_local.confidence / (1.0 + far) * (was_named ? parameters_.switch_gain : 1.0);
}

}  // namespace perceptor::identify
