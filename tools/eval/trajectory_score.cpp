#include "tools/eval/trajectory_score.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace perceptor {
namespace {

double mean(const std::vector<double>& values) {
  if (values.empty()) return 0.0;
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

MeanAndSigma mean_and_sigma(const std::vector<double>& values) {
  std::vector<double> squares;
  const double centre = mean(values);
  for (const double value : values) squares.push_back((value - centre) * (value - centre));
  return {centre, std::sqrt(mean(squares))};
}

/// The motion that the trajectory got wrong.
Position error_of(const Position& from, const Position& to, const Position& true_to_in_from) {
  return relative(true_to_in_from, relative(from, to));
}

double ratio(double part, std::int64_t whole) {
  return whole > 0 ? part / static_cast<double>(whole) : 0.0;
}

}  // namespace

DriftScore score_drift(const Trajectory& trajectory, const Trajectory& reference,
                       const TrajectoryScoreParameters& parameters) {
  DriftScore score;
  std::vector<std::optional<Position>> estimates;
  for (const TimedPose& timed : reference)
    estimates.push_back(pose_at(trajectory, timed.utime, parameters.max_gap));
  score.poses = static_cast<std::int64_t>(estimates.size());
  score.skipped = std::ranges::count(estimates, false, &std::optional<Position>::has_value);

  const std::vector<double> path = driven(reference);
  const auto compare = [&](std::size_t i, std::size_t j) {
    if (!estimates[i] || !estimates[j]) return;
    const Position error =
        error_of(*estimates[i], *estimates[j], relative(reference[i].pose, reference[j].pose));
    const double translation = length(error.location());
    const double heading = std::abs(error.a);
    ++score.pairs;
    score.translation += translation;
    score.heading += heading;
    score.translation_per_metre += translation / (path[j] - path[i]);
    score.heading_per_metre += heading / (path[j] - path[i]);
  };
  std::size_t first_far_enough = 0;
  for (std::size_t i = 0; i < reference.size(); ++i) {
    while (first_far_enough < path.size() && path[first_far_enough] - path[i] < parameters.min_path)
      ++first_far_enough;
    for (std::size_t j = first_far_enough;
         j < path.size() && path[j] - path[i] <= parameters.max_path; ++j)
      compare(i, j);
  }
  for (double* sum :
       {&score.translation, &score.heading, &score.translation_per_metre, &score.heading_per_metre})
    *sum = ratio(*sum, score.pairs);
  return score;
}

RelationScore score_relations(const Trajectory& trajectory, const std::vector<Relation>& relations,
                              const TrajectoryScoreParameters& parameters) {
  RelationScore score;
  std::vector<double> translations;
  std::vector<double> rotations;
  for (const Relation& relation : relations) {
    ++score.relations;
    const auto from = pose_at(trajectory, relation.from_utime, parameters.max_gap);
    const auto to = pose_at(trajectory, relation.to_utime, parameters.max_gap);
    if (!from || !to) {
      ++score.skipped;
      continue;
    }
    const Position error = error_of(*from, *to, relation.to_in_from);
    translations.push_back(length(error.location()));
    rotations.push_back(std::abs(error.a));
  }
  score.translation = mean_and_sigma(translations);
  score.rotation = mean_and_sigma(rotations);
  return score;
}

}  // namespace perceptor
