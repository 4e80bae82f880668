#include "components/localize/candidates.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>

#include "common/geometry/angle.hpp"

namespace perceptor::localize {
namespace {

/// Poses in cells of place and heading: of those in one cell the best is kept.
class Cells {
 public:
  explicit Cells(const CandidateParameters& parameters) : parameters_(parameters) {}

  bool has(const Position& pose) const { return best_.contains(key_of(pose)); }
  void add(const Candidate& candidate) {
    best_.emplace(key_of(candidate.local_in_world), candidate);
  }

  std::vector<Candidate> best_first() const {
    std::vector<Candidate> all;
    for (const auto& [key, candidate] : best_) all.push_back(candidate);
    std::ranges::stable_sort(all, std::ranges::greater{}, &Candidate::explained);
    return all;
  }

 private:
  using Key = std::tuple<int, int, int>;
  Key key_of(const Position& pose) const {
    const auto cell = [](double value, double size) {
      return static_cast<int>(std::floor(value / size));
    };
    return {cell(pose.x, parameters_.cell), cell(pose.y, parameters_.cell),
            cell(pose.a, parameters_.cell_angle)};
  }

  CandidateParameters parameters_;
  std::map<Key, Candidate> best_;
};

/// The pose that turns by `turn` and lays two walls on two fronts.
std::optional<Position> laid_on(const Line& p, const Line& q, const Front& on_p, const Front& on_q,
                                double turn) {
  const Position rotation{0.0, 0.0, wrap_angle(turn)};
  const Vector2 to_p = on_p.line.middle - perceptor::transform(rotation, p.middle);
  const Vector2 to_q = on_q.line.middle - perceptor::transform(rotation, q.middle);
  const double sine = cross(on_p.line.normal, on_q.line.normal);
  if (std::abs(sine) < 0.1) return std::nullopt;
  const double by_p = on_p.line.normal.dot(to_p);
  const double by_q = on_q.line.normal.dot(to_q);
  const Vector2 translation =
      (by_p * -perpendicular(on_q.line.normal) + by_q * perpendicular(on_p.line.normal)) / sine;
  return Position{translation.x(), translation.y(), rotation.a};
}

class Finder {
 public:
  Finder(const World& world, const std::vector<LocalWall>& walls,
         const CandidateParameters& parameters)
      : world_(world), walls_(walls), parameters_(parameters), cells_(parameters) {}

  void lay_pairs() {
    const std::vector<LocalWall> longest = longest_walls(parameters_.walls);
    for (std::size_t i = 0; i < longest.size(); ++i)
      for (std::size_t j = i + 1; j < longest.size(); ++j)
        lay_pair(longest[i].line, longest[j].line);
  }

  void lay_corners() {
    for (const LocalWall& wall : walls_)
      for (const std::size_t end : {0U, 1U})
        if (wall.is_corner[end])
          for (const Face& face : world_.faces()) lay_corner(wall, face, end);
  }

  void slide_along_fronts() {
    for (const LocalWall& wall : longest_walls(parameters_.slid))
      for (const Front& front : world_.fronts())
        if (front.length >= parameters_.min_share * wall.line.length) slide_along(wall.line, front);
  }

  std::vector<Candidate> best_first() const { return cells_.best_first(); }

 private:
  std::vector<LocalWall> longest_walls(int count) const {
    std::vector<LocalWall> longest = walls_;
    std::ranges::stable_sort(longest, std::ranges::greater{},
                             [](const LocalWall& wall) { return wall.line.length; });
    longest.resize(std::min(longest.size(), static_cast<std::size_t>(count)));
    return longest;
  }

  void slide_along(const Line& wall, const Front& front) {
    const double turn = wrap_angle(turn_between(wall, front.line));
    const Vector2 turned = perceptor::transform({0.0, 0.0, turn}, wall.middle);
    const double reach = wall.length / 2.0;
    const double begin = front.pieces.front().from - reach;
    const double way = front.pieces.back().to + reach - begin;
    const auto steps = static_cast<int>(way / parameters_.slide);
    for (int i = 0; i <= steps; ++i) {
      const Vector2 place = point_at(front.line, begin + i * parameters_.slide) - turned;
      const Position pose{place.x(), place.y(), turn};
      if (lies_on(wall, front, pose)) add(pose);
    }
  }

  void lay_pair(const Line& p, const Line& q) {
    const double between = turn_between(p, q);
    if (std::abs(std::sin(between)) < std::sin(parameters_.min_angle)) return;
    for (const Front& on_p : world_.fronts()) {
      if (on_p.length < parameters_.min_share * p.length) continue;
      world_.for_fronts_along(
          angle(on_p.line.along) + between, parameters_.max_angle, [&](const Front& on_q) {
            if (on_q.length < parameters_.min_share * q.length) return;
            const double error = angle_difference(between, turn_between(on_p.line, on_q.line));
            const double turn = turn_between(p, on_p.line) + error / 2.0;
            const auto pose = laid_on(p, q, on_p, on_q, turn);
            if (pose && lies_on(p, on_p, *pose) && lies_on(q, on_q, *pose)) add(*pose);
          });
    }
  }

  void lay_corner(const LocalWall& wall, const Face& face, std::size_t end) {
    const double turn = wrap_angle(turn_between(wall.line, face.line));
    const Vector2& corner = end == 0 ? wall.segment.a : wall.segment.b;
    const Vector2& onto = end == 0 ? face.segment.a : face.segment.b;
    const Vector2 place = onto - perceptor::transform({0.0, 0.0, turn}, corner);
    const double common = std::min(wall.line.length, face.line.length);
    if (common >= parameters_.min_share * wall.line.length) add({place.x(), place.y(), turn});
  }

  bool lies_on(const Line& line, const Front& front, const Position& pose) const {
    return length_on(front, transform(pose, line)) >= parameters_.min_share * line.length;
  }

  void add(const Position& pose) {
    if (!cells_.has(pose))
      cells_.add({pose, explained_length(world_, walls_, pose, tolerance_of(parameters_))});
  }

  const World& world_;
  const std::vector<LocalWall>& walls_;
  CandidateParameters parameters_;
  Cells cells_;
};

}  // namespace

LayTolerance tolerance_of(const CandidateParameters& parameters) {
  return {parameters.max_angle, parameters.max_offset};
}

std::vector<Candidate> find_candidates(const World& world, const std::vector<LocalWall>& walls,
                                       const CandidateParameters& parameters) {
  Finder finder(world, walls, parameters);
  finder.lay_pairs();
  finder.lay_corners();
  finder.slide_along_fronts();
  std::vector<Candidate> candidates = finder.best_first();
  if (candidates.size() > static_cast<std::size_t>(parameters.count))
    candidates.resize(static_cast<std::size_t>(parameters.count));
  return candidates;
}

}  // namespace perceptor::localize
