#include "tools/eval/world_view.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "common/geometry/angle.hpp"

namespace perceptor {
namespace {

class Caster {
 public:
  explicit Caster(const BeamFan& fan) : fan_(fan), hits_(fan.beams) {
    for (BeamHit& hit : hits_) hit.range = std::numeric_limits<double>::infinity();
  }

  /// `side` as the laser sees it.
  void add_side(const Segment& side, std::size_t index) {
    const double turn = angle_difference(angle(side.a), angle(side.b));
    const double first = turn > 0.0 ? angle(side.a) : angle(side.b);
    const Vector2 along_side = side.b - side.a;
    sweep(first, std::abs(turn), [&](double bearing) -> BeamHit {
      const Vector2 beam(std::cos(bearing), std::sin(bearing));
      const double across = cross(beam, along_side);
      if (across == 0.0) return {kNoSide, 0.0, std::numeric_limits<double>::infinity()};
      const double range = cross(side.a, along_side) / across;
      const double share = cross(side.a, beam) / across;
      return {index, std::clamp(share, 0.0, 1.0) * length(side), range};
    });
  }

  void add_body(const Vector2& centre, double radius) {
    const double away = length(centre);
    const double half = away > radius ? std::asin(radius / away) : std::numbers::pi;
    sweep(angle(centre) - half, 2.0 * half, [&](double) -> BeamHit {
      return {kNoSide, 0.0, std::max(away - radius, 0.0)};
    });
  }

  std::vector<BeamHit> hits() && {
    for (BeamHit& hit : hits_)
      if (hit.range > fan_.reach) hit.side = kNoSide;
    return std::move(hits_);
  }

 private:
  /// All beams with a bearing from `first` on, over `turn`: also where that passes half a turn.
  template <class Hit>
  void sweep(double first, double turn, const Hit& hit_at) {
    for (const double round : {-2.0 * std::numbers::pi, 0.0, 2.0 * std::numbers::pi}) {
      const double from = (first + round - fan_.angle_min) / fan_.angle_increment;
      const double to = from + turn / fan_.angle_increment;
      const double last = static_cast<double>(fan_.beams) - 1.0;
      if (to < 0.0 || from > last) continue;
      const auto end = static_cast<std::size_t>(std::min(std::floor(to), last));
      for (auto beam = static_cast<std::size_t>(std::max(std::ceil(from), 0.0)); beam <= end;
           ++beam) {
        const BeamHit hit =
            hit_at(fan_.angle_min + static_cast<double>(beam) * fan_.angle_increment);
        if (hit.range >= 0.0 && hit.range < hits_[beam].range) hits_[beam] = hit;
      }
    }
  }

  BeamFan fan_;
  std::vector<BeamHit> hits_;
};

}  // namespace

std::vector<BeamHit> cast_beams(const TrueWorld& world, const std::vector<Body>& bodies,
                                const Position& laser_in_world, const BeamFan& fan) {
  const Position world_in_laser = inverse(laser_in_world);
  Caster caster(fan);
  for (std::size_t i = 0; i < world.sides.size(); ++i)
    caster.add_side(transform(world_in_laser, world.sides[i].segment), i);
  for (const Body& body : bodies)
    caster.add_body(transform(world_in_laser, body.centre), body.radius);
  return std::move(caster).hits();
}

double SideView::seen() const {
  double sum = 0.0;
  for (const Stretch& stretch : stretches) sum += stretch.to - stretch.from;
  return sum;
}

double SideView::distance_to(double along) const {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Stretch& stretch : stretches)
    nearest = std::min(nearest, std::abs(std::clamp(along, stretch.from, stretch.to) - along));
  return nearest;
}

std::vector<SideView> side_views(const std::vector<BeamHit>& hits, std::size_t sides,
                                 double max_gap) {
  std::vector<SideView> views(sides);
  for (std::size_t i = 0; i < hits.size(); ++i) {
    if (hits[i].side == kNoSide) continue;
    SideView& view = views[hits[i].side];
    ++view.beams;
    if (i == 0 || hits[i - 1].side != hits[i].side) continue;
    const auto [from, to] = std::minmax(hits[i - 1].along, hits[i].along);
    if (to - from > max_gap) continue;
    Stretch* last = view.stretches.empty() ? nullptr : &view.stretches.back();
    if (last != nullptr && last->from <= to && from <= last->to) {
      *last = {std::min(last->from, from), std::max(last->to, to)};
    } else {
      view.stretches.push_back({from, to});
    }
  }
  return views;
}

}  // namespace perceptor
