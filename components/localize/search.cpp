#include "components/localize/search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "common/geometry/angle.hpp"

namespace perceptor::localize {
namespace {

/// Some beams of the first and the last keyframe: enough to choose by.
std::vector<Keyframe> glances_of(const std::vector<Keyframe>& keyframes,
                                 const SearchParameters& parameters) {
  const auto every = static_cast<std::size_t>(parameters.glance_every);
  std::vector<Keyframe> glances;
  for (const Keyframe* keyframe : {&keyframes.front(), &keyframes.back()}) {
    glances.push_back({keyframe->robot_in_local, {}, keyframe->way});
    for (std::size_t i = 0; i < keyframe->beams.size(); i += every)
      glances.back().beams.push_back(keyframe->beams[i]);
  }
  return glances;
}

double glance(const World& world, const Position& local_in_world,
              const std::vector<Keyframe>& glances, const BeamFitParameters& parameters) {
  double fit = 0.0;
  for (const Keyframe& keyframe : glances)
    fit += fit_beams(world, compose(local_in_world, keyframe.robot_in_local), keyframe.beams,
                     parameters)
               .log_likelihood;
  return fit;
}

/// The candidates that fit best, at a glance: few beams, and as exact as candidates are before
/// they are aligned.
std::vector<Position> most_likely(const World& world, const std::vector<Candidate>& candidates,
                                  const std::vector<Keyframe>& glances,
                                  const SearchParameters& parameters) {
  std::vector<std::pair<double, Position>> rated;
  rated.reserve(candidates.size());
  BeamFitParameters coarse = parameters.beams;
  coarse.sigma = parameters.glance_sigma;
  coarse.behind = coarse.anything;
  for (const Candidate& candidate : candidates)
    rated.emplace_back(glance(world, candidate.local_in_world, glances, coarse),
                       candidate.local_in_world);
  std::ranges::stable_sort(rated, std::ranges::greater{}, &std::pair<double, Position>::first);
  std::vector<Position> best;
  for (const auto& [fit, pose] : rated)
    if (best.size() < static_cast<std::size_t>(parameters.glances)) best.push_back(pose);
  return best;
}

/// Uphill, where walls leave the pose loose: moved along and turned about where the robot is.
Position climb(const World& world, const Position& local_in_world,
               const std::vector<Keyframe>& glances, const SearchParameters& parameters) {
  const Position robot_in_local = glances.back().robot_in_local;
  Position robot_in_world = compose(local_in_world, robot_in_local);
  const auto local = [&](const Position& robot) { return compose(robot, inverse(robot_in_local)); };
  double best = glance(world, local_in_world, glances, parameters.beams);
  double step = parameters.climb;
  while (step >= parameters.climb_end) {
    for (const Position& move :
         {Position{step, 0.0, 0.0}, Position{-step, 0.0, 0.0}, Position{0.0, step, 0.0},
          Position{0.0, -step, 0.0}, Position{0.0, 0.0, step}, Position{0.0, 0.0, -step}}) {
      const Position next = compose(robot_in_world, move);
      const double rated = glance(world, local(next), glances, parameters.beams);
      if (rated <= best) continue;
      best = rated;
      robot_in_world = next;
    }
    step /= 2.0;
  }
  return local(robot_in_world);
}

/// `way`: the robot in the world at each keyframe.
Hypothesis rate(const World& world, const Position& local_in_world,
                const std::vector<Position>& way, const Question& question,
                const SearchParameters& parameters) {
  const auto count = static_cast<double>(way.size());
  Hypothesis hypothesis;
  hypothesis.local_in_world = local_in_world;
  for (std::size_t i = 0; i < way.size(); ++i) {
    const BeamFit fit = fit_beams(world, way[i], question.keyframes[i].beams, parameters.beams);
    hypothesis.by_keyframe.push_back(fit.log_likelihood);
    hypothesis.log_likelihood += fit.log_likelihood;
    hypothesis.explained += fit.explained / count;
    hypothesis.through += fit.through / count;
  }
  hypothesis.log_likelihood /= count;
  hypothesis.log_likelihood -=
      parameters.strange_wall * strange_length(world, question.walls, local_in_world,
                                               tolerance_of(parameters.candidates),
                                               parameters.long_wall);
  hypothesis.log_likelihood *=
      std::pow(views(question.keyframes, parameters), parameters.view_exponent);
  return hypothesis;
}

/// Best first; of those at one place only the best. Two places are compared where the robot is now:
/// that is what would be claimed.
std::vector<Hypothesis> best_of_each_place(std::vector<Hypothesis> all,
                                           const Position& robot_in_local,
                                           const SearchParameters& parameters) {
  std::ranges::stable_sort(all, std::ranges::greater{}, &Hypothesis::log_likelihood);
  std::vector<Hypothesis> apart;
  for (const Hypothesis& hypothesis : all) {
    const Position place = compose(hypothesis.local_in_world, robot_in_local);
    const bool is_known = std::ranges::any_of(apart, [&](const Hypothesis& better) {
      return is_same_place(compose(better.local_in_world, robot_in_local), place, parameters);
    });
    if (!is_known) apart.push_back(hypothesis);
  }
  return apart;
}

/// A place as it comes out of the competition: how far it may be off before its way is bent.
constexpr double kPlaceSigma = 0.2;          // [m]
constexpr double kPlaceHeadingSigma = 0.15;  // [rad]

}  // namespace

Hypothesis judge(const World& world, const Position& local_in_world, const Question& question,
                 const SearchParameters& parameters) {
  std::vector<Position> way;
  way.reserve(question.keyframes.size());
  for (const Keyframe& keyframe : question.keyframes)
    way.push_back(compose(local_in_world, keyframe.robot_in_local));
  return rate(world, local_in_world, way, question, parameters);
}

Hypothesis follow(const World& world, const Position& local_in_world, const Question& question,
                  const SearchParameters& parameters) {
  const std::vector<Keyframe>& keyframes = question.keyframes;
  const Keyframe& last = keyframes.back();
  const Eigen::Vector3d sigmas(kPlaceSigma, kPlaceSigma, kPlaceHeadingSigma);
  PoseEstimate robot{compose(local_in_world, last.robot_in_local), sigmas.cwiseAbs2().asDiagonal()};
  std::vector<Position> way(keyframes.size());
  for (std::size_t i = keyframes.size(); i-- > 0;) {
    if (i + 1 < keyframes.size()) {
      const Position step = relative(keyframes[i + 1].robot_in_local, keyframes[i].robot_in_local);
      robot = predict(robot, step, 1.0, parameters.bend);
    }
    robot = align_beams(world, keyframes[i].beams, robot, parameters.beam_alignment);
    way[i] = robot.pose;
  }
  return rate(world, compose(way.back(), inverse(last.robot_in_local)), way, question, parameters);
}

double views(const std::vector<Keyframe>& keyframes, const SearchParameters& parameters) {
  double moved = 0.0;
  double turned = 0.0;
  for (std::size_t i = 1; i < keyframes.size(); ++i) {
    const Position& here = keyframes[i].robot_in_local;
    double from_nearest = std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j < i; ++j)
      from_nearest =
          std::min(from_nearest, distance(keyframes[j].robot_in_local.location(), here.location()));
    moved += from_nearest;
    turned += std::abs(relative(keyframes[i - 1].robot_in_local, here).a);
  }
  return 1.0 + moved / parameters.view +
         std::min(parameters.turned_views, turned / parameters.view_angle);
}

bool is_same_place(const Position& p, const Position& q, const SearchParameters& parameters) {
  return distance(p.location(), q.location()) < parameters.same_place &&
         std::abs(angle_difference(p.a, q.a)) < parameters.same_heading;
}

std::vector<Hypothesis> search(const World& world, const Question& question,
                               const SearchParameters& parameters) {
  const std::vector<LocalWall>& walls = question.walls;
  const std::vector<Keyframe>& keyframes = question.keyframes;
  const auto is_impossible = [&](const Position& local_in_world) {
    return question.is_possible && !question.is_possible(local_in_world);
  };
  std::vector<Candidate> candidates = find_candidates(world, walls, parameters.candidates);
  std::erase_if(candidates, [&](const Candidate& c) { return is_impossible(c.local_in_world); });
  const std::vector<Keyframe> glances = glances_of(keyframes, parameters);
  std::vector<Position> poses = question.known;
  for (const Position& candidate : most_likely(world, candidates, glances, parameters)) {
    const auto alignment = align(world, walls, {candidate, {}}, false, parameters.alignment);
    if (alignment) poses.push_back(alignment->frame_in_world.pose);
    poses.push_back(climb(world, candidate, glances, parameters));
  }
  std::erase_if(poses, is_impossible);
  std::vector<Hypothesis> all;
  all.reserve(poses.size());
  for (const Position& pose : poses) all.push_back(judge(world, pose, question, parameters));
  const auto looks_through = [&](const Hypothesis& place) {
    return place.through > parameters.max_through;
  };
  std::erase_if(all, looks_through);
  const Position robot_in_local = keyframes.back().robot_in_local;
  std::vector<Hypothesis> places = best_of_each_place(std::move(all), robot_in_local, parameters);
  if (parameters.followed == 0) return places;
  const auto followed = static_cast<std::size_t>(parameters.followed);
  if (places.size() > followed) places.resize(followed);
  for (Hypothesis& place : places)
    place = follow(world, place.local_in_world, question, parameters);
  return best_of_each_place(std::move(places), robot_in_local, parameters);
}

}  // namespace perceptor::localize
