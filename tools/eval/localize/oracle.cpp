#include "tools/eval/localize/oracle.hpp"

#include <algorithm>
#include <cmath>

#include "common/geometry/angle.hpp"
#include "components/localize/beam_fit.hpp"

namespace perceptor {
namespace {

constexpr std::size_t kGlanced = 4;  // of so many beams one is looked at, at first

/// Nothing but how much the map explains and what goes through is asked of the fit.
localize::BeamFitParameters within(double tolerance) {
  localize::BeamFitParameters parameters;
  parameters.sigma = tolerance / localize::kHitSigmas;
  parameters.through = tolerance;
  return parameters;
}

std::vector<localize::Beam> some_of(const std::vector<localize::Beam>& beams) {
  std::vector<localize::Beam> some;
  for (std::size_t i = 0; i < beams.size(); i += kGlanced) some.push_back(beams[i]);
  return some;
}

struct Shares {
  double explained = 0.0;
  double through = 0.0;
};

class Oracle {
 public:
  Oracle(const localize::World& world, const std::vector<TrueView>& views,
         const OracleParameters& parameters)
      : world_(world),
        views_(views),
        parameters_(parameters),
        start_(views.front().robot_in_world),
        glance_(some_of(views.front().beams)),
        truth_(shares(start_)) {}

  std::optional<Position> elsewhere() const {
    Vector2 low = world_.faces().front().segment.a;
    Vector2 high = low;
    for (const localize::Face& face : world_.faces()) {
      low = low.cwiseMin(face.segment.a);
      high = high.cwiseMax(face.segment.a);
    }
    const auto columns = static_cast<int>(std::ceil((high.x() - low.x()) / parameters_.step));
    const auto rows = static_cast<int>(std::ceil((high.y() - low.y()) / parameters_.step));
    for (const double turn : turns())
      for (int i = 0; i < columns; ++i)
        for (int j = 0; j < rows; ++j) {
          const Position place{low.x() + i * parameters_.step, low.y() + j * parameters_.step,
                               wrap_angle(start_.a + turn)};
          if (!is_here(place) && is_worth_it(place))
            if (const auto found = refined(place)) return found;
        }
    return std::nullopt;
  }

 private:
  /// Between the directions of any two faces: elsewhere the walls would stand askew.
  std::vector<double> turns() const {
    std::vector<double> turns;
    for (const localize::Front& p : world_.fronts())
      for (const localize::Front& q : world_.fronts()) {
        const double turn = turn_between(p.line, q.line);
        const auto is_known = [&](double known) {
          return std::abs(angle_difference(known, turn)) < parameters_.same_angle;
        };
        if (std::ranges::none_of(turns, is_known)) turns.push_back(turn);
      }
    return turns;
  }

  bool is_here(const Position& place) const {
    return distance(place.location(), start_.location()) < parameters_.same_place &&
           std::abs(angle_difference(place.a, start_.a)) < parameters_.same_heading;
  }

  /// At a first glance, by few beams of the first view.
  bool is_worth_it(const Position& place) const {
    constexpr double kSlack = 0.2;
    const localize::BeamFit here = fit_beams(world_, place, glance_, within(parameters_.glance));
    return here.explained >= truth_.explained - kSlack && here.through <= truth_.through + kSlack;
  }

  localize::BeamFit fit_of(const TrueView& view, const Position& start) const {
    const Position robot = compose(start, relative(start_, view.robot_in_world));
    return fit_beams(world_, robot, view.beams, within(parameters_.tolerance));
  }

  /// Of the whole drive that begins here.
  Shares shares(const Position& start) const {
    Shares sum;
    double beams = 0.0;
    for (const TrueView& view : views_) {
      const localize::BeamFit fit = fit_of(view, start);
      const auto count = static_cast<double>(view.beams.size());
      sum.explained += count * fit.explained;
      sum.through += count * fit.through;
      beams += count;
    }
    return {sum.explained / beams, sum.through / beams};
  }

  /// What the map explains of every other view, less what goes through it; or something below
  /// `least`, as soon as it cannot be more.
  double rate(const Position& start, double least) const {
    constexpr std::size_t kEvery = 2;
    double all = 0.0;
    for (std::size_t i = 0; i < views_.size(); i += kEvery)
      all += static_cast<double>(views_[i].beams.size());
    double left = all;
    double sum = 0.0;
    for (std::size_t i = 0; i < views_.size() && (sum + left) / all >= least; i += kEvery) {
      const localize::BeamFit fit = fit_of(views_[i], start);
      const auto count = static_cast<double>(views_[i].beams.size());
      sum += count * (fit.explained - fit.through);
      left -= count;
    }
    return (sum + left) / all;
  }

  /// Uphill from a place of the grid.
  std::optional<Position> refined(Position place) const {
    const double least = truth_.explained - truth_.through - 0.3;
    double best = rate(place, least);
    if (best < least) return std::nullopt;
    constexpr double kLeastStep = 0.01;
    double step = parameters_.step / 2.0;
    while (step > kLeastStep) {
      bool is_better = true;
      while (is_better) {
        is_better = false;
        for (const Position& move :
             {Position{step, 0.0, 0.0}, Position{-step, 0.0, 0.0}, Position{0.0, step, 0.0},
              Position{0.0, -step, 0.0}, Position{0.0, 0.0, step / 2.0},
              Position{0.0, 0.0, -step / 2.0}}) {
          const Position next = place + move;
          const double rated = rate(next, best);
          if (rated <= best) continue;
          best = rated;
          place = next;
          is_better = true;
          break;
        }
      }
      step /= 2.0;
    }
    const Shares there = shares(place);
    const bool is_as_good = there.explained >= truth_.explained - parameters_.fewer &&
                            there.through <= truth_.through + parameters_.more_through;
    if (is_here(place) || !is_as_good) return std::nullopt;
    return place;
  }

  const localize::World& world_;
  const std::vector<TrueView>& views_;
  OracleParameters parameters_;
  Position start_;
  std::vector<localize::Beam> glance_;  ///< some of the first view's
  Shares truth_;
};

}  // namespace

std::optional<Position> elsewhere(const localize::World& world, const std::vector<TrueView>& views,
                                  const OracleParameters& parameters) {
  if (views.empty()) return std::nullopt;
  return Oracle(world, views, parameters).elsewhere();
}

}  // namespace perceptor
