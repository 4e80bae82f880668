#include "components/proximity/surroundings.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>

#include "common/geometry/angle.hpp"
#include "common/geometry/polygon.hpp"

namespace perceptor {
namespace {

constexpr double kFullTurn = 2.0 * std::numbers::pi;

struct Nearest {
  double distance_squared = std::numeric_limits<double>::infinity();
  Vector2 location = Vector2::Zero();

  bool is_there() const { return std::isfinite(distance_squared); }
};

/// What ends in one sector.
struct Tally {
  int outside = 0;       // beams that end outside the footprint
  int inside = 0;        // beams that end inside it
  double covered = 0.0;  // [rad] by what ends inside it
  Nearest nearest_outside;
  Nearest nearest_inside;
};

/// The angle that one beam stands for, in the laser frame.
struct BeamArc {
  double to_right = 0.0;  // [rad] clockwise of the beam
  double to_left = 0.0;   // [rad] counter-clockwise of it
};

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

/// Half-way to the neighbours, but no further than the median gap: where beams are missing,
/// those beside the hole do not stand for it. The outermost beams reach as far outward as
/// inward. A single beam stands for no angle at all.
std::vector<BeamArc> beam_arcs(const std::vector<double>& bearings) {
  std::vector<BeamArc> arcs(bearings.size());
  if (bearings.size() < 2) return arcs;

  std::vector<std::size_t> order(bearings.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&bearings](std::size_t beam) { return bearings[beam]; });

  std::vector<double> gaps;
  for (std::size_t i = 0; i + 1 < order.size(); ++i)
    gaps.push_back(bearings[order[i + 1]] - bearings[order[i]]);
  const double typical_gap = median(gaps);

  for (std::size_t i = 0; i < gaps.size(); ++i) {
    const double half_way = std::min(gaps[i] / 2.0, typical_gap);
    arcs[order[i]].to_left = half_way;
    arcs[order[i + 1]].to_right = half_way;
  }
  arcs[order.front()].to_right = arcs[order.front()].to_left;
  arcs[order.back()].to_left = arcs[order.back()].to_right;
  return arcs;
}

class Sectors {
 public:
  explicit Sectors(int number) : width_(kFullTurn / number), number_(number) {}

  double width() const { return width_; }

  int at(double bearing) const {
    return std::min(static_cast<int>(from_back(bearing) / width_), number_ - 1);
  }

  /// How far behind the beginning of its sector a bearing lies [rad].
  double offset(double bearing) const { return from_back(bearing) - at(bearing) * width_; }

 private:
  /// [0, 2 pi), of a bearing in (-pi, pi]: +pi is -pi, and so the beginning of sector 0.
  static double from_back(double bearing) {
    const double turn = bearing + std::numbers::pi;
    return turn < kFullTurn ? turn : 0.0;
  }

  double width_;
  int number_;
};

/// Finds the sector of one place after the other. Beams come by bearing, so that most end in the
/// sector of the one before, and that is seen without an arc tangent.
class SectorFinder {
 public:
  explicit SectorFinder(const Sectors& sectors) : sectors_(sectors) {}

  int at(const Vector2& location) {
    if (!is_well_inside(location)) go_to(sectors_.at(angle(location)));
    return sector_;
  }

 private:
  /// Further from both borders than rounding reaches.
  bool is_well_inside(const Vector2& location) const {
    const double margin = 1e-9 * location.lpNorm<1>();
    return cross(begin_, location) > margin && cross(location, end_) > margin;
  }

  void go_to(int sector) {
    const double begin = sector * sectors_.width() - std::numbers::pi;
    const double end = begin + sectors_.width();
    sector_ = sector;
    begin_ = {std::cos(begin), std::sin(begin)};
    end_ = {std::cos(end), std::sin(end)};
  }

  Sectors sectors_;
  int sector_ = 0;
  Vector2 begin_ = Vector2::Zero();  // directions of its borders; zero: not yet known
  Vector2 end_ = Vector2::Zero();
};

/// How much of the sector in which the beam ends is covered by what the beam stands for, seen
/// from the robot's centre [rad].
double covered_angle(const LaserScan& scan, const BeamEnd& end, const BeamArc& arc,
                     const Sectors& sectors) {
  const auto bearing_of_turned = [&](double turn) {
    const double in_laser = scan.bearings[end.beam] + turn;
    return angle(transform(scan.laser_in_robot, Vector2(end.range * std::cos(in_laser),
                                                        end.range * std::sin(in_laser))));
  };
  const double bearing = angle(end.location);
  const double first = angle_difference(bearing, bearing_of_turned(-arc.to_right));
  const double second = angle_difference(bearing, bearing_of_turned(arc.to_left));

  const double from = std::max(0.0, sectors.offset(bearing) + std::min(first, second));
  const double to = std::min(sectors.width(), sectors.offset(bearing) + std::max(first, second));
  return std::max(0.0, to - from);
}

void note_if_nearer(Nearest& nearest, const Nearest& other) {
  if (other.distance_squared < nearest.distance_squared) nearest = other;
}

std::vector<Tally> tally_beam_ends(const LaserScan& scan, const std::vector<Vector2>& footprint,
                                   const Sectors& sectors, int num_sectors) {
  std::vector<Tally> tallies(static_cast<std::size_t>(num_sectors));
  std::vector<BeamArc> arcs;  // made when the first beam needs them: few scans do
  SectorFinder finder(sectors);
  for (const BeamEnd& end : beam_ends(scan)) {
    const Nearest here{end.location.squaredNorm(), end.location};
    Tally& tally = tallies[static_cast<std::size_t>(finder.at(end.location))];
    if (contains(footprint, end.location)) {
      if (arcs.empty()) arcs = beam_arcs(scan.bearings);
      ++tally.inside;
      tally.covered += covered_angle(scan, end, arcs[end.beam], sectors);
      note_if_nearer(tally.nearest_inside, here);
    } else {
      ++tally.outside;
      note_if_nearer(tally.nearest_outside, here);
    }
  }
  return tallies;
}

bool is_contact(const Tally& tally, double sector_width, double contact_share) {
  const bool most_end_inside = tally.inside > tally.outside;
  return most_end_inside && tally.covered >= contact_share * sector_width;
}

Sector judge(const Tally& tally, double sector_width, const ProximityParameters& parameters) {
  Sector sector;
  sector.contact = is_contact(tally, sector_width, parameters.contact_share);

  const int usable = tally.outside + (sector.contact ? tally.inside : 0);
  sector.blind = usable < parameters.min_beams_for_seen;

  Nearest nearest = tally.nearest_outside;
  if (sector.contact) note_if_nearer(nearest, tally.nearest_inside);
  if (nearest.is_there()) {
    sector.distance = length(nearest.location);
    sector.bearing = angle(nearest.location);
  }
  sector.too_close = sector.contact || sector.distance < parameters.radius;
  return sector;
}

}  // namespace

Surroundings look_around(const LaserScan& scan, const std::vector<Vector2>& footprint,
                         const ProximityParameters& parameters) {
  const Sectors sectors(parameters.num_sectors);
  const std::vector<Tally> tallies =
      tally_beam_ends(scan, footprint, sectors, parameters.num_sectors);

  Surroundings surroundings;
  for (const Tally& tally : tallies) {
    const Sector sector = judge(tally, sectors.width(), parameters);
    if (sector.distance < surroundings.nearest_distance) {
      surroundings.nearest_distance = sector.distance;
      surroundings.nearest_bearing = sector.bearing;
    }
    surroundings.sectors.push_back(sector);
    if (!sector.contact) surroundings.own_beams += tally.inside;
  }
  return surroundings;
}

}  // namespace perceptor
