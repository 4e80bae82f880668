#include "components/identify/openings.hpp"

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

#include "components/identify/candidates.hpp"
#include "components/identify/crossing.hpp"

namespace perceptor::identify {
namespace {

bool is_door(const Candidate& candidate) { return candidate.opening.type == ObjectType::door; }

Segment segment_of(const Candidate& candidate) {
  return {candidate.opening.first.location, candidate.opening.second.location};
}

/// Doors first, then the more certain one, then the narrower one. The places decide a tie, so
/// that the order in which the walls came does not.
auto rank(const Candidate& c) {
  const Opening& o = c.opening;
  return std::tuple(!is_door(c), -o.confidence, c.width, o.first.location.x(), o.first.location.y(),
                    o.second.location.x(), o.second.location.y());
}

/// The walls of each are within max_angle of it, so two openings of one wall differ by up to
/// twice that.
bool lie_side_by_side(const Segment& s, const Segment& t, const OpeningParameters& parameters) {
  const auto [first, last] = projected_interval(s, t);
  const bool overlap_along = first < length(s) && last > 0.0;
  return overlap_along && smallest_relative_angle(s, t) <= 2.0 * parameters.max_angle &&
         mutual_perpendicular_distance(s, t) <= parameters.max_wall_thickness;
}

/// Whether two candidates are one opening: two faces of one wall, or two guesses at one gap.
bool are_one_opening(const Candidate& c, const Candidate& d, const OpeningParameters& parameters) {
  const Segment s = segment_of(c);
  const Segment t = segment_of(d);
  const double reach = 0.5 * (c.width + d.width) + parameters.max_wall_thickness;
  const bool are_apart = ((s.a + s.b) - (t.a + t.b)).squaredNorm() > 4.0 * reach * reach;
  if (are_apart) return false;
  return cross_each_other(s, t) || lie_side_by_side(s, t, parameters);
}

/// Goes through the ranked candidates and keeps what leaves each end and corner used once.
class Chooser {
 public:
  Chooser(Vector2 robot, const OpeningParameters& parameters)
      : robot_(std::move(robot)), parameters_(parameters) {}

  void consider_door(const Candidate& candidate) {
    if (!is_free(candidate)) return;
    use_points(candidate);
    claimed_.push_back(candidate);
    for (Candidate& other : chosen_) {
      if (!are_one_opening(candidate, other, parameters_)) continue;
      if (distance_to_robot(candidate) < distance_to_robot(other)) other = candidate;
      return;
    }
    chosen_.push_back(candidate);
  }

  void consider_possible_door(const Candidate& candidate) {
    if (!is_free(candidate)) return;
    const bool is_claimed = std::ranges::any_of(claimed_, [&](const Candidate& other) {
      return are_one_opening(candidate, other, parameters_);
    });
    if (is_claimed) return;
    use_points(candidate);
    claimed_.push_back(candidate);
    chosen_.push_back(candidate);
  }

  std::vector<Candidate> chosen() && {
    std::ranges::sort(chosen_, {}, rank);
    return std::move(chosen_);
  }

 private:
  bool is_free(const Candidate& candidate) const {
    return std::ranges::none_of(candidate.points,
                                [this](Index point) { return used_.contains(point); });
  }

  void use_points(const Candidate& candidate) {
    for (const Index point : candidate.points) {
      if (point != kNone) used_.insert(point);
    }
  }

  double distance_to_robot(const Candidate& candidate) const {
    return distance(robot_, middle(segment_of(candidate)));
  }

  Vector2 robot_;
  OpeningParameters parameters_;
  std::set<Index> used_;            ///< points of what was claimed
  std::vector<Candidate> claimed_;  ///< all that were good, both faces of a wall included
  std::vector<Candidate> chosen_;   ///< one for each opening
};

}  // namespace

std::vector<Opening> find_openings(const Map& map, const std::vector<Wall>& walls,
                                   const Vector2& robot, const OpeningParameters& parameters,
                                   const ConfidenceParameters& confidence) {
  std::vector<Candidate> candidates = find_candidates(map, walls, robot, parameters, confidence);
  std::ranges::sort(candidates, {}, rank);
  Chooser chooser(robot, parameters);
  for (const Candidate& candidate : candidates) {
    is_door(candidate) ? chooser.consider_door(candidate)
                       : chooser.consider_possible_door(candidate);
  }
  std::vector<Opening> openings;
  for (const Candidate& candidate : std::move(chooser).chosen()) {
    openings.push_back(candidate.opening);
  }
  return openings;
}

}  // namespace perceptor::identify
