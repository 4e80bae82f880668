/// @file Scenes for merge, drawn as segments with free space on their left, and a robot that
/// looks at them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "components/merge/merger.hpp"

namespace perceptor::merge {

/// [us] So long that the third scan confirms: it is half a second after the first.
inline constexpr std::int64_t kScanPeriod = 250'000;

/// A wall of a scene, and how a scan sees its ends.
struct Drawn {
  Segment segment;
  CornerMethod tail = CornerMethod::none;
  CornerMethod head = CornerMethod::none;
};

inline Drawn wall(double ax, double ay, double bx, double by,
                  CornerMethod tail = CornerMethod::none, CornerMethod head = CornerMethod::none) {
  return {{{ax, ay}, {bx, by}}, tail, head};
}

/// Adds a wall as a scan with an error of 5 mm over 40 beams would give it.
inline void add_wall(Map& map, const Drawn& drawn) {
  constexpr double kOffsetSigma = 0.001;
  constexpr double kEndSigma = 0.005;
  constexpr double kRadius = 0.2;
  const Index index = add_segment(map, drawn.segment, ObjectType::wall);
  Object& object = map.objects.back();
  object.free_side = FreeSide::left;
  object.support = 40;
  const double angle_sigma = kOffsetSigma * 3.5 / length(drawn.segment);
  object.line_covariance =
      Eigen::Vector2d(kOffsetSigma * kOffsetSigma, angle_sigma * angle_sigma).asDiagonal();
  for (const std::size_t end : {kTail, kHead}) {
    const auto point =
        static_cast<std::size_t>(map.objects[static_cast<std::size_t>(index)].points[end]);
    map.points[point].covariance = kEndSigma * kEndSigma * Eigen::Matrix2d::Identity();
    map.points[point].radius = kRadius;
    map.points[point].method = end == kTail ? drawn.tail : drawn.head;
  }
}

inline Map draw(const std::vector<Drawn>& scene) {
  Map map;
  for (const Drawn& drawn : scene) add_wall(map, drawn);
  return map;
}

/// A room of 4 m by 3 m with one corner at the origin, seen from inside.
inline std::vector<Drawn> room() {
  return {wall(0, 0, 4, 0), wall(4, 0, 4, 3), wall(4, 3, 0, 3), wall(0, 3, 0, 0)};
}

/// A merger and the scans it gets, one each kScanPeriod.
class Session {
 public:
  explicit Session(const MergeParameters& parameters = {}) : merger_(parameters) {}

  /// A scan, drawn in the zero frame.
  LocalMap see(const std::vector<Drawn>& scene, const Position& robot_in_zero = {2.0, 1.5, 0.3}) {
    return take(transform(draw(scene), inverse(robot_in_zero)), robot_in_zero);
  }

  LocalMap see_often(const std::vector<Drawn>& scene, int scans,
                     const Position& robot_in_zero = {2.0, 1.5, 0.3}) {
    LocalMap last;
    for (int i = 0; i < scans; ++i) last = see(scene, robot_in_zero);
    return last;
  }

  /// A scan in the robot frame.
  LocalMap take(const Map& walls, const Position& robot_in_zero) {
    utime_ += kScanPeriod;
    return merger_.update({utime_, robot_in_zero, {}, walls});
  }

  void wait(double seconds) { utime_ += static_cast<std::int64_t>(seconds * 1e6); }

  Merger& merger() { return merger_; }
  const std::vector<Wall>& walls() const { return merger_.walls(); }

 private:
  Merger merger_;
  std::int64_t utime_ = 1'000'000;
};

/// The published walls, seen from the local frame.
inline Map in_local(const LocalMap& local_map) {
  return transform(local_map.walls, local_map.robot_in_local.pose);
}

}  // namespace perceptor::merge
