#include "components/localize/localizer.hpp"

#include <cmath>
#include <limits>

#include "common/geometry/angle.hpp"
#include "common/time/stamp.hpp"

namespace perceptor::localize {
namespace {

double square(double value) { return value * value; }

PoseEstimate in_world(const Hypothesis& place, const Position& robot_in_local,
                      const LocalizerParameters& parameters) {
  const double sigma = parameters.found_sigma;
  const double heading_sigma = parameters.found_heading_sigma;
  const Eigen::Vector3d variances(square(sigma), square(sigma), square(heading_sigma));
  return {compose(place.local_in_world, robot_in_local), variances.asDiagonal()};
}

int count_leads(const Hypothesis& best, const Hypothesis& second) {
  int leads = 0;
  for (std::size_t i = 0; i < best.by_keyframe.size(); ++i)
    if (best.by_keyframe[i] > second.by_keyframe[i]) ++leads;
  return leads;
}

}  // namespace

void Localizer::clear() {
  lose(0);
  state_ = State::searching;
}

WorldPosition Localizer::update(const Sight& sight) {
  const std::vector<Beam> beams = choose_beams(sight.ends, parameters_.search.beams.beams);
  WorldPosition position;
  if (tracked_) track(sight, beams, position);
  take_answer(sight);
  if (keep_keyframe(sight, beams) && is_time_to_ask(sight.utime)) ask(sight);
  if (!position.robot_in_world) guess(sight, position);
  position.state = state_;
  position.places = static_cast<int>(places_.size());
  return position;
}

bool Localizer::keep_keyframe(const Sight& sight, const std::vector<Beam>& beams) {
  if (!keyframes_.empty()) {
    const Position step = relative(keyframes_.back().robot_in_local, sight.robot_in_local);
    const bool is_new = step.location().norm() >= parameters_.keyframes.distance ||
                        std::abs(step.a) >= parameters_.keyframes.angle;
    if (!is_new) return false;
  }
  if (keyframes_.size() == static_cast<std::size_t>(parameters_.keyframes.count))
    keyframes_.erase(keyframes_.begin());
  keyframes_.push_back({sight.robot_in_local, beams});
  return true;
}

void Localizer::track(const Sight& sight, const std::vector<Beam>& beams, WorldPosition& position) {
  const Position motion = relative(tracked_->robot_in_local, sight.robot_in_local);
  const double seconds = seconds_between(tracked_->utime, sight.utime);
  PoseEstimate estimate = predict(tracked_->robot_in_world, motion, seconds, parameters_.motion);
  PoseEstimate published = estimate;
  const std::vector<LocalWall> walls = local_walls(sight.walls, sight.utime);
  if (const auto alignment = align(world_, walls, estimate, true, parameters_.tracking)) {
    estimate = alignment->frame_in_world;
    published = estimate;
    published.covariance += alignment->map_covariance;
  }
  tracked_ = Tracked{estimate, sight.robot_in_local, sight.utime};
  position.robot_in_world = published;

  const BeamFit fit = fit_beams(world_, estimate.pose, beams, parameters_.search.beams);
  position.explained = fit.explained;
  position.through = fit.through;
  const bool is_bad = fit.explained < parameters_.watch.min_explained ||
                      fit.through > parameters_.watch.max_through;
  if (!is_bad) bad_since_.reset();
  if (is_bad && !bad_since_) bad_since_ = sight.utime;
  if (is_bad && seconds_between(*bad_since_, sight.utime) >= parameters_.watch.time)
    lose(sight.utime);
}

bool Localizer::is_time_to_ask(std::int64_t utime) const {
  if (answer_.valid()) return false;
  return !tracked_ || seconds_between(asked_, utime) >= parameters_.watch.period;
}

void Localizer::ask(const Sight& sight) {
  asked_ = sight.utime;
  std::vector<LocalWall> walls;
  for (const LocalWall& wall : local_walls(sight.walls, since_))
    walls.push_back(transform(sight.robot_in_local, wall));
  std::vector<Position> known;
  for (const Hypothesis& place : places_) known.push_back(place.local_in_world);
  if (tracked_)
    known.push_back(compose(tracked_->robot_in_world.pose, inverse(sight.robot_in_local)));
  answer_ = std::async(std::launch::async, [this, walls = std::move(walls),
                                            known = std::move(known), keyframes = keyframes_] {
    return search(world_, walls, keyframes, known, parameters_.search);
  });
}

void Localizer::take_answer(const Sight& sight) {
  if (!answer_.valid()) return;
  if (seconds_between(asked_, sight.utime) < parameters_.search_time) return;
  places_ = answer_.get();
  if (tracked_) {
    if (!still_wins(sight)) lose(sight.utime);
  } else if (is_claimed()) {
    state_ = State::tracking;
    tracked_ = Tracked{in_world(places_.front(), sight.robot_in_local, parameters_),
                       sight.robot_in_local, sight.utime};
  }
}

bool Localizer::is_claimed() const {
  const ClaimParameters& claim = parameters_.claim;
  if (places_.empty()) return false;
  const Hypothesis& best = places_.front();
  if (best.by_keyframe.size() < static_cast<std::size_t>(claim.min_keyframes)) return false;
  if (best.explained < claim.min_explained) return false;
  if (places_.size() < 2) return true;
  return best.log_likelihood - places_[1].log_likelihood >= claim.margin &&
         count_leads(best, places_[1]) >= claim.min_leads;
}

bool Localizer::is_ambiguous() const {
  const ClaimParameters& claim = parameters_.claim;
  if (tracked_ || places_.size() < 2) return false;
  const Hypothesis& best = places_.front();
  return best.by_keyframe.size() >= static_cast<std::size_t>(claim.ambiguous_keyframes) &&
         best.log_likelihood - places_[1].log_likelihood < claim.margin;
}

/// Nothing else explains the last keyframes better by a margin.
bool Localizer::still_wins(const Sight& sight) const {
  const Position here = tracked_->robot_in_world.pose;
  for (const Hypothesis& place : places_)
    if (is_same_place(compose(place.local_in_world, sight.robot_in_local), here,
                      parameters_.search))
      return places_.front().log_likelihood - place.log_likelihood < parameters_.claim.margin;
  return true;
}

void Localizer::guess(const Sight& sight, WorldPosition& position) const {
  position.ambiguous = is_ambiguous();
  if (places_.empty()) return;
  position.robot_in_world = tracked_ ? tracked_->robot_in_world
                                     : in_world(places_.front(), sight.robot_in_local, parameters_);
  position.explained = places_.front().explained;
  position.through = places_.front().through;
}

void Localizer::lose(std::int64_t utime) {
  state_ = State::lost;
  tracked_.reset();
  keyframes_.clear();
  places_.clear();
  answer_ = {};
  bad_since_.reset();
  since_ = utime;
}

}  // namespace perceptor::localize
