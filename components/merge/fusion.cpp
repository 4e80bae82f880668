#include "components/merge/fusion.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

namespace perceptor::merge {
namespace {

double square(double value) { return value * value; }

/// A line with its covariance at `anchor`.
struct LineEstimate {
  Vector2 anchor = Vector2::Zero();
  Vector2 along = Vector2::Zero();
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
};

/// What the other line says of the kept one, as offset and angle at the middle of the kept.
/// A difference that the two covariances do not explain is given less information, so that
/// one bad scan cannot move a wall.
LineEstimate fuse_lines(const Wall& kept, const Wall& other, const FusionParameters& parameters) {
  const Line line = line_of(kept.segment);
  const Line other_line = line_of(other.segment);
  const Vector2 to_other = other_line.middle - line.middle;
  const Eigen::Vector2d residual(line.normal.dot(to_other), turn_between(line, other_line));
  Eigen::Matrix2d from_kept;  // offset and angle of the kept line, at the middle of the other
  from_kept << 1.0, line.along.dot(to_other), 0.0, 1.0;

  const Eigen::Matrix2d innovation =
      from_kept * kept.covariance * from_kept.transpose() + other.covariance;
  const double sigmas = std::sqrt(residual.dot(innovation.inverse() * residual));
  const double inflation = std::max(1.0, sigmas / parameters.outlier_sigmas);

  const Eigen::Matrix2d measured = from_kept.transpose() * other.covariance.inverse() / inflation;
  LineEstimate fused;
  fused.covariance = (kept.covariance.inverse() + measured * from_kept).inverse();
  const Eigen::Vector2d change = fused.covariance * measured * residual;
  fused.anchor = line.middle + change[0] * line.normal;
  fused.along = std::cos(change[1]) * line.along + std::sin(change[1]) * line.normal;
  return fused;
}

/// One end during a merge; `place` is measured outwards along the fused line.
struct PlacedEnd {
  double place = 0.0;
  WallEnd end;
};

PlacedEnd average(const PlacedEnd& p, const PlacedEnd& q, const EndParameters& parameters) {
  const double information = 1.0 / p.end.variance + 1.0 / q.end.variance;
  PlacedEnd mean = p;
  mean.place = (p.place / p.end.variance + q.place / q.end.variance) / information;
  sharpen(mean.end, 1.0 / information, parameters);
  mean.end.overshoots = 0;
  return mean;
}

PlacedEnd replaced(const PlacedEnd& kept, const PlacedEnd& other) {
  PlacedEnd moved = other;
  if (moved.end.connected == kNone) moved.end.connected = kept.end.connected;
  moved.end.overshoots = 0;
  return moved;
}

/// One of them is where two lines meet, the other where beams pass the wall's end at some
/// distance from there: the wall does not reach as far as the lines say.
bool ends_before_corner(const PlacedEnd& corner, const PlacedEnd& seen,
                        const EndParameters& parameters) {
  return corner.end.method == CornerMethod::intersection && is_seen_as_end(seen.end) &&
         corner.place - seen.place > reach_of_seen(seen.end, parameters);
}

/// Where a wall that was seen twice ends. A known end is a measurement of the end, an unknown
/// one only says that the wall reaches so far.
PlacedEnd merge_ends(const PlacedEnd& kept, const PlacedEnd& other, int sightings_of_other,
                     const FusionParameters& parameters) {
  const double beyond = other.place - kept.place;
  const bool is_near = std::abs(beyond) <= std::max(kept.end.radius, other.end.radius);
  const bool both_known = is_known(kept.end) && is_known(other.end);

  if (is_near && ends_before_corner(kept, other, parameters.ends)) return replaced(kept, other);
  if (is_near && ends_before_corner(other, kept, parameters.ends)) return kept;
  if (both_known && is_near) return average(kept, other, parameters.ends);
  if (!is_known(kept.end)) {
    const bool is_found = is_known(other.end) && is_near;
    return is_found || beyond > 0.0 ? replaced(kept, other) : kept;
  }
  PlacedEnd stays = kept;
  if (is_near) stays.end.overshoots = 0;
  if (is_near || beyond < 0.0) return stays;
  stays.end.overshoots += sightings_of_other;
  return stays.end.overshoots >= parameters.overshoots ? replaced(kept, other) : stays;
}

/// The extent of the fused wall, its two ends with it.
void merge_extent(Wall& fused, const LineEstimate& line, const Wall& other,
                  const FusionParameters& parameters) {
  const Segment before = fused.segment;
  const std::array<Vector2, 2> kept_ends = {before.a, before.b};
  const std::array<Vector2, 2> other_ends = {other.segment.a, other.segment.b};
  std::array<Vector2, 2> ends;
  for (const std::size_t i : {kTail, kHead}) {
    const Vector2 outwards = i == kHead ? line.along : Vector2(-line.along);
    const auto place_of = [&](const Vector2& end) { return outwards.dot(end - line.anchor); };
    const PlacedEnd merged =
        merge_ends({place_of(kept_ends[i]), fused.ends[i]},
                   {place_of(other_ends[i]), other.ends[i]}, other.sightings, parameters);
    ends[i] = line.anchor + merged.place * outwards;
    fused.ends[i] = merged.end;
  }
  const double along = line.along.dot((ends[kTail] + ends[kHead]) / 2.0 - line.anchor);
  fused.segment = {ends[kTail], ends[kHead]};
  fused.covariance = moved_along(line.covariance, along);
}

void merge_evidence(Wall& fused, const Wall& other, const FusionParameters& parameters) {
  const bool is_new_sighting = other.last_seen > fused.last_seen;
  const int more = is_new_sighting ? 1 : 0;
  fused.sightings = std::max(fused.sightings + more, other.sightings);
  const double more_weight = is_new_sighting && !fused.doubted ? 1.0 : 0.0;
  fused.weight =
      std::min(parameters.max_weight, std::max(fused.weight + more_weight, other.weight));
  if (other.last_seen >= fused.last_seen)
    fused.support = is_new_sighting ? other.support : fused.support + other.support;
  fused.scans = std::max(fused.scans, other.scans);
  fused.first_seen = std::min(fused.first_seen, other.first_seen);
  fused.last_seen = std::max(fused.last_seen, other.last_seen);
  fused.contested = fused.contested && !is_new_sighting;
  fused.is_new = fused.confirmed ? fused.is_new : other.is_new;
  fused.confirmed = fused.confirmed || other.confirmed;
}

}  // namespace

Wall fuse(const Wall& kept, const Wall& other, const FusionParameters& parameters) {
  Wall fused = kept;
  const LineEstimate line = fuse_lines(kept, other, parameters);
  merge_extent(fused, line, other, parameters);
  fused.covariance(0, 0) = std::max(fused.covariance(0, 0), square(parameters.min_offset_sigma));
  fused.covariance(1, 1) = std::max(fused.covariance(1, 1), square(parameters.min_angle_sigma));
  merge_evidence(fused, other, parameters);
  return fused;
}

}  // namespace perceptor::merge
