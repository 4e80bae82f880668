#include "components/merge/association.hpp"

#include <optional>

namespace perceptor::merge {
namespace {

/// The laser stands where the wall can be seen, or so near its line that noise may decide.
bool is_on_free_side(const Line& line, const Vector2& laser, double tolerance) {
  return line.normal.dot(laser - line.middle) > -tolerance;
}

}  // namespace

std::vector<Match> match_walls(const std::vector<Wall>& sighted, const std::vector<Wall>& known,
                               const std::vector<Line>& known_lines, const Vector2& laser_in_local,
                               const SameWallParameters& parameters) {
  std::vector<Match> matches;
  matches.reserve(sighted.size());
  for (std::size_t i = 0; i < sighted.size(); ++i) {
    const Line line = line_of(sighted[i].segment);
    std::optional<std::size_t> best;
    double best_score = 0.0;
    for (std::size_t j = 0; j < known.size(); ++j) {
      if (are_far_apart(line, known_lines[j], parameters)) continue;
      const auto difference = compare(sighted[i], line, known[j], known_lines[j], parameters);
      if (!difference || (best && difference->score >= best_score)) continue;
      if (!is_on_free_side(known_lines[j], laser_in_local, parameters.max_offset)) continue;
      best = j;
      best_score = difference->score;
    }
    if (best) matches.push_back({i, *best});
  }
  return matches;
}

}  // namespace perceptor::merge
