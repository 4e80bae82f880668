#include "components/localize/localizer.hpp"

#include <algorithm>
#include <chrono>
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

bool speaks_against_pose(const BeamFit& fit, const WatchParameters& watch) {
  const bool is_poor = fit.explained < watch.poor_explained && fit.through > watch.poor_through;
  return fit.explained < watch.min_explained || fit.through > watch.max_through || is_poor;
}

int count_leads(const Hypothesis& best, const Hypothesis& second) {
  int leads = 0;
  for (std::size_t i = 0; i < best.by_keyframe.size(); ++i)
    if (best.by_keyframe[i] > second.by_keyframe[i]) ++leads;
  return leads;
}

/// As the places are that it is compared with.
Hypothesis rate_claim(const World& world, const Position& local_in_world, const Question& question,
                      const SearchParameters& parameters) {
  return parameters.followed > 0 ? follow(world, local_in_world, question, parameters)
                                 : judge(world, local_in_world, question, parameters);
}

}  // namespace

void Localizer::clear() {
  lose(0);
  state_ = State::searching;
  has_begun_ = false;
}

WorldPosition Localizer::update(const Sight& sight) {
  const std::vector<Beam> beams = choose_beams(sight.ends, parameters_.search.beams.beams);
  if (!has_begun_ && hint_) start_in_local_ = sight.robot_in_local;
  has_begun_ = true;
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
  double way = 0.0;
  if (!keyframes_.empty()) {
    const Position step = relative(keyframes_.back().robot_in_local, sight.robot_in_local);
    const double moved = step.location().norm();
    const double turned = std::abs(step.a);
    if (moved < parameters_.keyframes.distance && turned < parameters_.keyframes.angle)
      return false;
    way = keyframes_.back().way + moved + turned;
  }
  const auto is_far_back = [&](const Keyframe& keyframe) {
    return way - keyframe.way > parameters_.keyframes.reach;
  };
  std::erase_if(keyframes_, is_far_back);
  if (keyframes_.size() == static_cast<std::size_t>(parameters_.keyframes.count))
    forget_one_of_many();
  keyframes_.push_back({sight.robot_in_local, beams, way});
  return true;
}

/// The one whose neighbours are closest: the others stay spread over the way.
void Localizer::forget_one_of_many() {
  std::size_t least = 0;
  double gap = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i + 1 < keyframes_.size(); ++i) {
    const double without = keyframes_[i + 1].way - keyframes_[i - 1].way;
    if (without >= gap) continue;
    gap = without;
    least = i;
  }
  keyframes_.erase(keyframes_.begin() + static_cast<std::ptrdiff_t>(least));
}

void Localizer::lay_walls(const Sight& sight, double seconds, Tracked& tracked,
                          PoseEstimate& published) const {
  const std::vector<LocalWall> walls = local_walls(sight.scan_walls, 0);
  AlignmentParameters tracking = parameters_.tracking;
  tracking.map_sigma = std::max(parameters_.min_map_sigma, std::sqrt(tracked.map_variance));
  const auto alignment = align(world_, walls, tracked.robot_in_world, true, tracking);
  if (!alignment) return;
  const double share = 1.0 - std::exp(-seconds / parameters_.map_time);
  if (alignment->map_variance)
    tracked.map_variance += share * (*alignment->map_variance - tracked.map_variance);
  tracked.robot_in_world = published = alignment->frame_in_world;
  published.covariance += parameters_.walls_together * alignment->map_covariance;
}

/// The map's own error does not become less from scan to scan: it counts where the pose is
/// published, and not in the one that the next scan begins with.
void Localizer::lay_beams(const std::vector<Beam>& beams, Tracked& tracked,
                          PoseEstimate& published) const {
  const BeamAlignmentParameters& tracking = parameters_.search.beam_alignment;
  tracked.robot_in_world = published = align_beams(world_, beams, tracked.robot_in_world, tracking);
  published.covariance.topLeftCorner<2, 2>().diagonal().array() += square(tracking.map_sigma);
}

void Localizer::track(const Sight& sight, const std::vector<Beam>& beams, WorldPosition& position) {
  const Position motion = relative(tracked_->robot_in_local, sight.robot_in_local);
  const double seconds = seconds_between(tracked_->utime, sight.utime);
  tracked_->robot_in_world = predict(tracked_->robot_in_world, motion, seconds, parameters_.motion);
  tracked_->robot_in_local = sight.robot_in_local;
  tracked_->utime = sight.utime;
  PoseEstimate published = tracked_->robot_in_world;
  if (parameters_.track_by == TrackBy::beams)
    lay_beams(beams, *tracked_, published);
  else
    lay_walls(sight, seconds, *tracked_, published);
  position.robot_in_world = published;

  const BeamFit fit = fit_beams(world_, published.pose, beams, parameters_.search.beams);
  position.explained = fit.explained;
  position.through = fit.through;
  const bool is_bad = speaks_against_pose(fit, parameters_.watch);
  if (!is_bad) bad_since_.reset();
  if (is_bad && !bad_since_) bad_since_ = sight.utime;
  if (is_bad && seconds_between(*bad_since_, sight.utime) >= parameters_.watch.time)
    lose(sight.utime);
}

bool Localizer::is_time_to_ask(std::int64_t utime) const {
  if (answer_.valid()) return false;
  return !tracked_ || !checked_ || seconds_between(*checked_, utime) >= parameters_.watch.period;
}

void Localizer::ask(const Sight& sight) {
  asked_ = sight.utime;
  if (tracked_) checked_ = sight.utime;
  Question question;
  for (const LocalWall& wall : local_walls(sight.walls, since_))
    question.walls.push_back(transform(sight.robot_in_local, wall));
  question.keyframes = keyframes_;
  for (const Hypothesis& place : places_) question.known.push_back(place.local_in_world);
  question.is_possible = is_possible();
  std::optional<Position> own;
  if (tracked_) own = compose(tracked_->robot_in_world.pose, inverse(sight.robot_in_local));
  answer_ = std::async(std::launch::async, [this, own, question = std::move(question)] {
    Answer answer;
    if (own) answer.own = rate_claim(world_, *own, question, parameters_.search);
    answer.places = search(world_, question, parameters_.search);
    return answer;
  });
}

/// As the hint has it, until the robot was lost.
std::function<bool(const Position&)> Localizer::is_possible() const {
  if (!start_in_local_) return {};
  return [hint = *hint_, start = *start_in_local_](const Position& local_in_world) {
    return allows(hint, compose(local_in_world, start));
  };
}

void Localizer::take_answer(const Sight& sight) {
  if (!answer_.valid()) return;
  if (seconds_between(asked_, sight.utime) < parameters_.search_time) return;
  wait_for_answer();
  Answer answer = answer_.get();
  places_ = std::move(answer.places);
  if (tracked_) {
    if (answer.own) check_claim(*answer.own, sight);
    return;
  }
  if (!fits_together()) forget_older_half();
  if (!is_claimed()) return;
  state_ = State::tracking;
  tracked_ = Tracked{in_world(places_.front(), sight.robot_in_local, parameters_),
                     sight.robot_in_local, sight.utime, square(parameters_.tracking.map_sigma)};
  checked_.reset();
}

void Localizer::wait_for_answer() const {
  constexpr std::chrono::milliseconds kLittle{2};
  do meanwhile_();
  while (answer_.wait_for(kLittle) != std::future_status::ready);
}

/// Nowhere do all keyframes fit: the robot was carried away between them.
bool Localizer::fits_together() const {
  return keyframes_.size() < static_cast<std::size_t>(parameters_.keyframes.count) ||
         (!places_.empty() && places_.front().explained >= parameters_.claim.min_explained);
}

void Localizer::forget_older_half() {
  keyframes_.erase(keyframes_.begin(),
                   keyframes_.begin() + static_cast<std::ptrdiff_t>(keyframes_.size() / 2));
}

bool Localizer::is_claimed() const {
  const ClaimParameters& claim = parameters_.claim;
  if (places_.empty()) return false;
  const Hypothesis& best = places_.front();
  const bool is_expected = start_in_local_ && hint_->pose;  // one view is enough
  if (!is_expected && best.by_keyframe.size() < static_cast<std::size_t>(claim.min_keyframes))
    return false;
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

/// Another pose that explains the keyframes better by a margin ends the claim; one close by mends
/// it. What is right instead is told by the next answer: that this was wrong has to be seen.
void Localizer::check_claim(const Hypothesis& own, const Sight& sight) {
  if (places_.empty()) return;
  const Hypothesis& best = places_.front();
  if (best.log_likelihood - own.log_likelihood < parameters_.claim.lost_margin) return;
  const PoseEstimate better = in_world(best, sight.robot_in_local, parameters_);
  if (is_same_place(better.pose, tracked_->robot_in_world.pose, parameters_.search))
    tracked_->robot_in_world = better;
  else
    take_claim_back();
}

void Localizer::guess(const Sight& sight, WorldPosition& position) const {
  position.ambiguous = is_ambiguous();
  if (places_.empty()) return;
  position.robot_in_world = tracked_ ? tracked_->robot_in_world
                                     : in_world(places_.front(), sight.robot_in_local, parameters_);
  position.explained = places_.front().explained;
  position.through = places_.front().through;
}

void Localizer::take_claim_back() {
  start_in_local_.reset();
  state_ = State::lost;
  tracked_.reset();
}

void Localizer::lose(std::int64_t utime) {
  take_claim_back();
  keyframes_.clear();
  places_.clear();
  if (answer_.valid()) wait_for_answer();
  answer_ = {};
  bad_since_.reset();
  since_ = utime;
}

}  // namespace perceptor::localize
