/// @file Where merge and where odometry say that the robot was, over the local maps of a log.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "common/log/event_log.hpp"
#include "tools/eval/trajectory.hpp"

namespace perceptor {

/// Of one session, from one zero position on: robot_in_local and robot_in_zero begin anew with
/// each.
struct Track {
  std::int64_t session = 0;
  std::int64_t zero_utime = 0;  ///< names the zero frame
  Trajectory merge;             ///< robot_in_local
  Trajectory odometry;          ///< robot_in_zero, at the same times
};

/// [s] from its first map to its last.
double duration(const Track& track);

class TrackReader {
 public:
  /// Events in log order.
  void take(const LogEvent& event);

  /// In the order in which they began, each in order of time; none where no good LOCAL_MAP came.
  std::vector<Track> tracks() const;

  std::int64_t undecodable() const { return undecodable_; }  ///< LOCAL_MAP messages

 private:
  Track& track_of(std::int64_t session, std::int64_t zero_utime);

  std::vector<Track> tracks_;
  std::int64_t undecodable_ = 0;
};

/// The one that lasts longest; the first of equals. There has to be one.
const Track& longest(const std::vector<Track>& tracks);

}  // namespace perceptor
