/// @file When each channel was last heard, in the robot's time, and whether the robot or the log
/// began anew.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace perceptor::viewer {

class ChannelClock {
 public:
  /// A message came. False: its session is another, or its channel's time stepped back by more than
  /// 2 s, and whatever was heard before is over.
  bool take(const std::string& channel, std::int64_t utime, std::int64_t session);

  bool has_heard_anything() const { return !heard_.empty(); }

  /// [us] of a channel's newest message; none: nothing came.
  std::optional<std::int64_t> heard(const std::string& channel) const;

  /// [us] of the newest message of all; 0: none yet.
  std::int64_t now() const;

  /// A sentence for each channel that comes with each scan or odometry and is older than the newest
  /// by more than `stale` [s].
  std::vector<std::string> notes(double stale) const;

 private:
  std::optional<std::int64_t> session_;
  std::map<std::string, std::int64_t> heard_;  ///< [us]
};

}  // namespace perceptor::viewer
