#include "components/scan/beams.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <Eigen/Core>

#include "common/geometry/polygon.hpp"
#include "common/model/sweeping_laser.hpp"

namespace perceptor::scan {
namespace {

/// No range is better known than this [m]: keeps weights finite where a scan claims no noise.
constexpr double kSmallestSigma = 1e-4;

/// [m] A laser moves by less during a sweep.
constexpr double kSweepMotion = 0.1;

/// Beams that are looked at together.
constexpr int kBlock = 16;

template <class Do>
void for_each_array(Beams& beams, Do act) {
  act(beams.x);
  act(beams.y);
  act(beams.range);
  act(beams.bearing);
  act(beams.beam);
}

/// A circle has to begin somewhere: where neighbouring beams end farthest apart. That does not
/// depend on where the sweep began, nor on which way it went, and is a gap if there is one.
std::size_t best_seam(const Beams& beams) {
  std::size_t seam = 0;
  double farthest = -1.0;
  for (std::size_t i = 0; i < beams.count; ++i) {
    const std::size_t before = i > 0 ? i - 1 : beams.count - 1;
    const double apart = (beams.end(i) - beams.end(before)).squaredNorm();
    if (apart <= farthest) continue;
    farthest = apart;
    seam = i;
  }
  return seam;
}

void begin_at(Beams& beams, std::size_t first) {
  const auto ahead = static_cast<std::ptrdiff_t>(first);
  for_each_array(beams, [&](auto& array) { std::ranges::rotate(array, array.begin() + ahead); });
  for (auto bearing = beams.bearing.end() - ahead; bearing != beams.bearing.end(); ++bearing)
    *bearing += 2.0 * std::numbers::pi;
}

/// In a circle, all beams stand there twice.
void reserve_for(std::size_t beams, Beams& in) {
  for_each_array(in, [beams](auto& array) { array.reserve(2 * beams); });
  in.weight.reserve(2 * beams);
}

void weigh(Beams& beams) {
  const double base = beams.range_sigma * beams.range_sigma;
  const double growth = beams.sigma_growth * beams.sigma_growth;
  beams.weight.resize(beams.count);
  for (std::size_t i = 0; i < beams.count; ++i) {
    const double squared = beams.range[i] * beams.range[i];
    beams.weight[i] = squared / (base + growth * squared);
  }
}

/// Moves the elements begin to end - 1 to an earlier place.
template <class T>
void shift(std::vector<T>& array, std::size_t begin, std::size_t end, std::size_t to) {
  if (begin == to) return;
  std::copy(array.begin() + static_cast<std::ptrdiff_t>(begin),
            array.begin() + static_cast<std::ptrdiff_t>(end),
            array.begin() + static_cast<std::ptrdiff_t>(to));
}

/// How far from the laser the footprint reaches [m].
double reach_of(const std::vector<Vector2>& footprint, const Vector2& laser) {
  double reach = 0.0;
  if (footprint.size() < 3) return reach;
  for (const Vector2& corner : footprint) reach = std::max(reach, distance(corner, laser));
  return reach + kSweepMotion;
}

}  // namespace

double Beams::sigma(std::size_t i) const { return range[i] / std::sqrt(weight[i]); }

BeamReader::BeamReader(const NoiseParameters& noise, const GapParameters& gap,
                       std::vector<Vector2> footprint)
    : noise_(noise), gap_(gap), footprint_(std::move(footprint)) {}

void BeamReader::lay_out(const LaserScan& scan, const Twist& twist, Beams& beams) const {
  const std::size_t size = scan.size();
  const std::vector<double>& cosine = directions_.cosine();
  const std::vector<double>& sine = directions_.sine();
  beams.x.resize(size);
  beams.y.resize(size);
  beams.laser = scan.laser_in_robot.location();
  SweepingLaser laser(scan.laser_in_robot, twist, scan.time_increment);
  if (laser.stands()) {
    for (std::size_t i = 0; i < size; ++i) {
      beams.x[i] = scan.ranges[i] * cosine[i];
      beams.y[i] = scan.ranges[i] * sine[i];
    }
    return;
  }
  for (std::size_t i = 0; i < size; ++i) {
    const SweepingLaser::Place place = laser.next();
    const double along_x = place.cosine * cosine[i] - place.sine * sine[i];
    const double along_y = place.sine * cosine[i] + place.cosine * sine[i];
    beams.x[i] = place.origin.x() + scan.ranges[i] * along_x;
    beams.y[i] = place.origin.y() + scan.ranges[i] * along_y;
    if (i == size / 2) beams.laser = place.origin;
  }
  for (std::size_t i = 0; i < size; ++i) {
    beams.x[i] -= beams.laser.x();
    beams.y[i] -= beams.laser.y();
  }
}

void BeamReader::put_in_order(const LaserScan& scan, Beams& beams) {
  const std::vector<std::uint32_t>& order = directions_.order();
  beams.range = scan.ranges;
  beams.bearing = scan.bearings;
  beams.beam = order;
  if (directions_.is_sorted()) return;
  for (std::vector<double>* array : {&beams.x, &beams.y, &beams.range, &beams.bearing}) {
    in_order_.resize(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) in_order_[i] = (*array)[order[i]];
    array->swap(in_order_);
  }
}

void BeamReader::keep_returns(const LaserScan& scan, Beams& beams) const {
  const double nearest = std::max(scan.valid_min, std::numeric_limits<double>::min());
  const double farthest = std::min(scan.valid_max, std::numeric_limits<double>::max());
  const double own_reach = reach_of(footprint_, scan.laser_in_robot.location());
  // Whether a block returned from beyond the robot: comparisons alone would not see a NaN.
  const auto is_plain = [&](std::size_t i) {
    const Eigen::Map<const Eigen::Array<double, kBlock, 1>> block(beams.range.data() + i);
    return block.minCoeff() >= std::max(nearest, own_reach) && block.maxCoeff() <= farthest &&
           !std::isnan(block.sum());
  };
  const auto is_usable = [&](std::size_t i) {
    const double range = beams.range[i];
    const bool returned = range >= nearest && range <= farthest;  // so that no NaN does
    if (!returned) return false;
    const bool is_on_robot = range < own_reach && contains(footprint_, beams.location(i));
    beams.in_footprint += is_on_robot ? 1 : 0;
    return !is_on_robot;
  };

  const std::size_t size = scan.size();
  beams.in_footprint = 0;
  beams.count = 0;
  for (std::size_t i = 0; i < size; ++i) {
    if (!is_usable(i)) continue;
    const std::size_t begin = i++;
    while (i + kBlock <= size && is_plain(i)) i += kBlock;
    while (i < size && is_usable(i)) ++i;
    for_each_array(beams, [&](auto& array) { shift(array, begin, i, beams.count); });
    beams.count += i - begin;
  }
  beams.no_return = size - beams.count - beams.in_footprint;
  for_each_array(beams, [&](auto& array) { array.resize(beams.count); });
}

void BeamReader::read(const LaserScan& scan, const Twist& twist, Beams& beams) {
  reserve_for(scan.size(), beams);
  in_order_.reserve(2 * scan.size());  // it changes places with those
  directions_.update(scan);
  beams.increment = directions_.increment();
  beams.grazing = 1.0 / std::sin(gap_.min_incidence);
  beams.max_hole = gap_.max_hole;
  beams.range_sigma = std::max(scan.range_sigma, kSmallestSigma);
  beams.sigma_growth = noise_.sigma_growth;
  lay_out(scan, twist, beams);
  put_in_order(scan, beams);
  keep_returns(scan, beams);
  beams.is_circle = directions_.is_circle() && beams.count > 2;
  if (beams.is_circle) begin_at(beams, best_seam(beams));
  weigh(beams);
}

void repeat(Beams& beams) {
  const auto count = static_cast<std::ptrdiff_t>(beams.count);
  const auto append = [&](auto& array) {
    array.resize(2 * beams.count);
    std::copy_n(array.begin(), count, array.begin() + count);
  };
  for_each_array(beams, append);
  append(beams.weight);
  for (std::size_t i = beams.count; i < 2 * beams.count; ++i)
    beams.bearing[i] += 2.0 * std::numbers::pi;
}

double variance_across(const Beams& beams, std::size_t i, double line_distance,
                       const NoiseParameters& noise) {
  return line_distance * line_distance / beams.weight[i] +
         noise.surface_roughness * noise.surface_roughness;
}

double distance_between_beams(const Beams& beams, std::size_t i, const Vector2& normal) {
  const double incidence = std::abs(beams.end(i).dot(normal)) / beams.range[i];
  const double stretched = incidence * beams.grazing > 1.0 ? 1.0 / incidence : beams.grazing;
  return beams.range[i] * beams.increment * stretched;
}

}  // namespace perceptor::scan
